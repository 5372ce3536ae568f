// Damaged input is refused with the file's name; failed saves leave the old file whole and nothing beside it.
#include <OpenImageIO/half.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <limits>

#include "brushes/atomic_file.h"
#include "brushes/map_file.h"
#include "chart_surface.h"
#include "image_files.h"

namespace relievo::map_damage_test {
namespace {
namespace fs = std::filesystem;

template <typename Action>
std::string error_of(Action action) {
    try {
        action();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return {};
}

void expect_refused(const fs::path& path, const std::string& reason) {
    const std::string error = error_of([&] { load_map(path); });
    EXPECT_NE(error.find(path.string()), std::string::npos) << "'" << error << "' names no " << path;
    EXPECT_NE(error.find(reason), std::string::npos) << "'" << error << "' says no '" << reason << "'";
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
}

HeightMap noise(int width, int height) {
    HeightMap map(width, height);
    std::uint32_t random = 7;
    for (std::uint16_t& texel : map.texels()) {
        random = random * 1664525u + 1013904223u;
        texel = static_cast<std::uint16_t>(random >> 16);
    }
    return map;
}

TEST(Damage, cut_off_anywhere_is_an_error_never_half_a_map) {
    const TestFolder folder;
    const HeightMap map = noise(64, 48);
    const auto check = [&](const std::string& name, const std::string& kind) {
        const std::string whole = bytes_of(folder / name);
        const std::string cut_name = "cut" + fs::path(name).extension().string();
        ASSERT_EQ(load_map(folder / name).map.hash(), map.hash()) << kind;
        int refused = 0;
        constexpr int kCuts = 60;
        for (std::size_t i = 0; i < kCuts; ++i) {
            write_bytes(folder / cut_name, whole.substr(0, whole.size() * i / kCuts));
            const std::string error = error_of([&] {
                // Trailing bookkeeping may be missing, texels may not.
                EXPECT_EQ(load_map(folder / cut_name).map.hash(), map.hash())
                    << kind << " cut at " << i << "/60";
            });
            if (error.empty()) continue;
            ++refused;
            EXPECT_NE(error.find(cut_name), std::string::npos) << error;
            EXPECT_EQ(error.find('\n'), std::string::npos) << error;
        }
        EXPECT_GE(refused, kCuts - 2) << kind;
    };
    save_map(map, folder / "m.png", MapFormat::png16);
    check("m.png", "png");
    save_map(map, folder / "m.exr", MapFormat::exr_float);
    check("m.exr", "exr");
    std::vector<std::uint16_t> rows;
    for (int y = map.height() - 1; y >= 0; --y)
        for (int x = 0; x < map.width(); ++x) rows.push_back(map.at(x, y));
    for (const std::string compression : {"none", "zip", "lzw"})
        for (const int tile : {0, 32}) {
            OIIO::ImageSpec spec(map.width(), map.height(), 1, OIIO::TypeDesc::UINT16);
            spec.attribute("compression", compression);
            spec.tile_width = spec.tile_height = tile;
            write_image(folder / "m.tif", spec, rows.data());
            check("m.tif", "tiff " + compression + (tile ? " tiled" : ""));
        }
}

TEST(Damage, flipped_bits_in_compressed_files_never_pass_as_other_heights) {
    const TestFolder folder;
    const HeightMap map = noise(24, 16);
    for (const std::string name : {"m.png", "m.tif"}) {
        save_map(map, folder / name, format_of(name));
        const std::string whole = bytes_of(folder / name);
        // A TIFF's header and directory, which stand first here, carry no checksum.
        const std::size_t begin = name == "m.tif" ? 300 : 0;
        for (std::size_t i = begin; i < whole.size(); i += 3) {
            std::string damaged = whole;
            damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
            write_bytes(folder / ("flipped-" + name), damaged);
            error_of([&] {
                EXPECT_EQ(load_map(folder / ("flipped-" + name)).map.hash(), map.hash()) << name << i;
            });
        }
    }
}

TEST(Damage, what_is_no_map_is_refused_with_the_reason) {
    const TestFolder folder;
    expect_refused(folder / "missing.png", "no such file");
    fs::create_directory(folder / "folder.png");
    expect_refused(folder / "folder.png", "not a file");
    write_bytes(folder / "empty.png", "");
    expect_refused(folder / "empty.png", "cannot be opened as an image");
    write_bytes(folder / "text.tif", "This is no image, but the words of someone in a hurry.\n");
    expect_refused(folder / "text.tif", "cannot be opened as an image");

    const std::vector<std::uint8_t> bytes(64 * 3);
    write_image(folder / "photo.jpg", OIIO::ImageSpec(8, 8, 3, OIIO::TypeDesc::UINT8), bytes.data());
    expect_refused(folder / "photo.jpg", "16-bit PNG or TIFF");
    const std::vector<float> floats(64, 0.5f);
    write_image(folder / "float.tif", OIIO::ImageSpec(8, 8, 1, OIIO::TypeDesc::FLOAT), floats.data());
    expect_refused(folder / "float.tif", "holds float values");

    const std::vector<std::uint16_t> row(16385);
    write_image(folder / "wide.png", OIIO::ImageSpec(16385, 1, 1, OIIO::TypeDesc::UINT16), row.data());
    expect_refused(folder / "wide.png", "at most 16384");
    EXPECT_NE(error_of([&] { load_map(folder / "wide.png", {1.0, 1.0}); }).find("low"), std::string::npos);
}

TEST(Damage, several_pages_are_refused) {
    const TestFolder folder;
    const std::vector<std::uint16_t> texels(64, 3);
    const OIIO::ImageSpec page(8, 8, 1, OIIO::TypeDesc::UINT16);
    const std::vector<OIIO::ImageSpec> pages{page, page};
    const std::string path = (folder / "pages.tif").string();
    auto out = OIIO::ImageOutput::create(path);
    ASSERT_TRUE(out->open(path, 2, pages.data()));
    ASSERT_TRUE(out->write_image(OIIO::TypeDesc::UINT16, texels.data()));
    ASSERT_TRUE(out->open(path, page, OIIO::ImageOutput::AppendSubimage));
    ASSERT_TRUE(out->write_image(OIIO::TypeDesc::UINT16, texels.data()));
    ASSERT_TRUE(out->close());
    expect_refused(path, "several images");
}

TEST(Damage, nan_and_infinity_name_their_texel) {
    const TestFolder folder;
    for (const auto& [bad, name] : {std::pair{std::numeric_limits<float>::quiet_NaN(), "NaN"},
                                    {std::numeric_limits<float>::infinity(), "infinity"},
                                    {-std::numeric_limits<float>::infinity(), "infinity"}}) {
        std::vector<float> values(12, 0.5f);
        values[1 * 4 + 2] = bad;  // column 2 of the middle row
        write_image(folder / "f.exr", OIIO::ImageSpec(4, 3, 1, OIIO::TypeDesc::FLOAT), values.data());
        expect_refused(folder / "f.exr", std::string(name) + " at texel (2, 1)");
        std::vector<half> halves(values.begin(), values.end());
        write_image(folder / "h.exr", OIIO::ImageSpec(4, 3, 1, OIIO::TypeDesc::HALF), halves.data());
        expect_refused(folder / "h.exr", std::string(name) + " at texel (2, 1)");
    }
}

// While it lives, no file of this process grows beyond `bytes`: what a full disk does to a save.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &old_);
        const rlimit limit{bytes, old_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &old_);
        std::signal(SIGXFSZ, old_handler_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

  private:
    rlimit old_{};
    void (*old_handler_)(int);
};

TEST(FailedSave, disk_full_at_any_point_leaves_the_old_file_whole) {
    const TestFolder folder;
    const HeightMap old = noise(32, 32), now = noise(128, 128);
    for (const std::string name : {"m.png", "m.tif", "m.exr"}) {
        save_map(old, folder / name, format_of(name));
        const std::string before = bytes_of(folder / name);
        for (const rlim_t bytes : {0u, 1u, 4096u, 20000u}) {
            std::string error;
            {
                const FileSizeLimit limit(bytes);
                error = error_of([&] { save_map(now, folder / name, format_of(name)); });
            }
            EXPECT_NE(error.find((folder / name).string()), std::string::npos) << "'" << error << "'";
            EXPECT_EQ(bytes_of(folder / name), before);
        }
    }
    EXPECT_EQ(folder.names().size(), 3u) << "no temporary file is left";
}

TEST(FailedSave, a_program_that_is_killed_in_the_middle_leaves_nothing_beside_the_file) {
    const TestFolder folder;
    const int nameless = ::open(folder.path().c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600);
    if (nameless < 0) GTEST_SKIP() << "this file system has no files without names";
    ::close(nameless);
    write_bytes(folder / "m.tif", "old");
    const std::vector<std::byte> content(1 << 20);
    const pid_t child = ::fork();
    if (child == 0) {
        std::signal(SIGXFSZ, SIG_DFL);  // which kills
        const rlimit limit{4096, 4096}, none{0, 0};
        ::setrlimit(RLIMIT_CORE, &none);
        ::setrlimit(RLIMIT_FSIZE, &limit);
        write_file_atomically(folder / "m.tif", content);
        ::_exit(0);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGXFSZ);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"m.tif"});
    EXPECT_EQ(bytes_of(folder / "m.tif"), "old");
}

TEST(FailedSave, unwritable_places_are_named) {
    const TestFolder folder;
    const HeightMap map(4, 4);
    fs::create_directory(folder / "folder.png");
    for (const fs::path& path : {folder / "folder.png", folder / "no" / "such.png", fs::path("/proc/m.png"),
                                 fs::path("/dev/null")}) {
        const std::string error = error_of([&] { save_map(map, path, MapFormat::png16); });
        EXPECT_NE(error.find(path.string()), std::string::npos) << "'" << error << "' for " << path;
    }
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"folder.png"}));
}

// Nothing is read-only for root: as root, its scope runs with the rights of nobody, to whom the folder is
// given.
class WithoutRoot {
  public:
    explicit WithoutRoot(const fs::path& folder) {
        constexpr uid_t kNobody = 65534;
        if (::geteuid() == 0 && ::chown(folder.c_str(), kNobody, kNobody) == 0)
            dropped_ = ::seteuid(kNobody) == 0;
    }
    ~WithoutRoot() { EXPECT_TRUE(!dropped_ || ::seteuid(0) == 0); }
    WithoutRoot(const WithoutRoot&) = delete;
    WithoutRoot& operator=(const WithoutRoot&) = delete;

  private:
    bool dropped_ = false;
};

TEST(FailedSave, read_only_file_and_folder_are_respected) {
    const TestFolder folder;
    const WithoutRoot rights(folder / "");
    if (::geteuid() == 0) GTEST_SKIP() << "no user but root here";
    save_map(HeightMap(4, 4, 1), folder / "m.png", MapFormat::png16);
    fs::permissions(folder / "m.png", fs::perms(0444));
    EXPECT_NE(error_of([&] { save_map(HeightMap(4, 4, 2), folder / "m.png", MapFormat::png16); }), "");
    EXPECT_EQ(load_map(folder / "m.png").map.at(0, 0), 1);
    fs::create_directory(folder / "closed");
    fs::permissions(folder / "closed", fs::perms(0555));
    EXPECT_NE(error_of([&] { save_map(HeightMap(4, 4), folder / "closed" / "m.png", MapFormat::png16); }),
              "");
    fs::permissions(folder / "closed", fs::perms(0755));
}

}  // namespace
}  // namespace relievo::map_damage_test
