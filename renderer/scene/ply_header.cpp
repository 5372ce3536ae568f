// PLY headers: elements with a count, each followed by its properties.
#include "renderer/scene/ply_header.h"

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>

#include "renderer/scene/text_scan.h"

namespace relievo {

namespace {

constexpr std::string_view kIntegers[] = {"char", "uchar", "short", "ushort", "int",   "uint",
                                          "int8", "uint8", "int16", "uint16", "int32", "uint32"};
constexpr std::string_view kReals[] = {"float", "double", "float32", "float64"};

bool is_integer(std::string_view type) {
    return std::count(std::begin(kIntegers), std::end(kIntegers), type) > 0;
}
bool is_number(std::string_view type) {
    return is_integer(type) || std::count(std::begin(kReals), std::end(kReals), type) > 0;
}

class HeaderReader {
  public:
    HeaderReader(const std::filesystem::path& path, std::string_view bytes)
        : path_(path), rest_(bytes), file_size_(bytes.size()) {}

    PlyHeader read() {
        if (next_line_of_file() != "ply") fail("is not a PLY file (it must start with the line 'ply')");
        add("ply");
        for (bool more = true; more;) {
            if (rest_.empty()) fail("the PLY header is cut off (no line 'end_header')");
            more = read_line(next_line_of_file());
        }
        if (!has_format_) fail("the PLY header has no line 'format'");
        for (const char* name : {"x", "y", "z"}) {
            if (!vertex_.contains(name))
                fail(std::string("the PLY header has no vertices with a property ") + name);
        }
        if (!has_faces_) fail("the PLY header has no faces with a list 'vertex_indices'");
        header_.original_bytes = file_size_ - rest_.size();
        header_.original_lines = line_;
        return std::move(header_);
    }

  private:
    [[noreturn]] void fail(const std::string& what) const {
        throw std::invalid_argument(path_.string() + ": line " + std::to_string(line_) + ": " + what);
    }
    std::string_view next_line_of_file() {
        ++line_;
        return next_line(rest_);
    }
    void add(const std::string& line) {
        header_.text += line;
        header_.text += '\n';
        ++header_.lines;
    }

    // False at the header's end.
    bool read_line(std::string_view line) {
        std::string_view words = line;
        std::array<std::string_view, 5> word;
        std::size_t count = 0;
        for (std::string_view w = next_token(words); !w.empty() && count < word.size();
             w = next_token(words)) {
            word[count++] = w;
        }
        if (count == 0 || word[0] == "comment" || word[0] == "obj_info") return true;
        if (word[0] == "end_header") {
            add("end_header");
            return false;
        }
        if (word[0] == "format" && count == 3) {
            read_format(word[1]);
        } else if (word[0] == "element" && count == 3) {
            read_element(word[1], word[2]);
        } else if (word[0] == "property" && count == 3) {
            read_property(word[1], word[2]);
        } else if (word[0] == "property" && word[1] == "list" && count == 5) {
            read_list(word[2], word[3], word[4]);
        } else {
            fail(in_quotes(line) + " does not belong into a PLY header");
        }
        return true;
    }

    void read_format(std::string_view format) {
        if (format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian") {
            fail("the format " + in_quotes(format) +
                 " must be ascii, binary_little_endian or binary_big_endian");
        }
        if (has_format_ || !element_.empty()) fail("'format' must stand once, before the elements");
        has_format_ = true;
        header_.ascii = format == "ascii";
        add("format " + std::string(format) + " 1.0");
    }

    void read_element(std::string_view name, std::string_view count) {
        const auto number = parse_integer(count);
        if (!number || *number < 0) fail("the number of " + in_quotes(name) + " must be 0 or more");
        if (static_cast<std::uint64_t>(*number) > file_size_) {  // no entry takes less than a byte
            fail("cut off: the header promises " + std::string(count) + " of " + in_quotes(name) +
                 ", more than the file has bytes");
        }
        if (!elements_.insert(std::string(name)).second)
            fail("the element " + in_quotes(name) + " is given twice");
        if (name == "face" && !elements_.contains("vertex")) fail("vertices must stand before faces");
        element_ = name;
        add("element " + std::string(name) + " " + std::string(count));
    }

    void read_property(std::string_view type, std::string_view name) {
        if (element_.empty()) fail("a property must follow an element");
        if (!is_number(type)) fail("unknown type " + in_quotes(type));
        if (element_ == "vertex") {
            if (name == "x") header_.doubles = type == "double" || type == "float64";
            if (name == "texture_u" || name == "texture_v") name.remove_prefix(8);
            if (!vertex_.insert(std::string(name)).second)
                fail("the property " + in_quotes(name) + " is given twice");
        }
        add("property " + std::string(type) + " " + std::string(name));
    }

    void read_list(std::string_view count_type, std::string_view type, std::string_view name) {
        if (element_.empty()) fail("a property must follow an element");
        if (!is_integer(count_type) || !is_number(type)) {
            fail("unknown types of a list: " + in_quotes(count_type) + ", " + in_quotes(type));
        }
        if (element_ == "vertex") fail("lists on vertices are not read");
        if (element_ == "face" && (name == "vertex_indices" || name == "vertex_index")) {
            if (!is_integer(type)) fail("vertex indices must be integers");
            if (has_faces_) fail("the faces have two lists of vertices");
            has_faces_ = true;
        }
        if (element_ == "face" && name == "texcoord") header_.corner_uvs = true;
        add("property list " + std::string(count_type) + " " + std::string(type) + " " + std::string(name));
    }

    const std::filesystem::path& path_;
    std::string_view rest_;
    std::size_t file_size_, line_ = 0;
    PlyHeader header_;
    std::string element_;
    std::set<std::string> elements_, vertex_;
    bool has_format_ = false, has_faces_ = false;
};

}  // namespace

PlyHeader read_ply_header(const std::filesystem::path& path, std::string_view bytes) {
    return HeaderReader(path, bytes).read();
}

}  // namespace relievo
