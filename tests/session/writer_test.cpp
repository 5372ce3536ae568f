// The journal on disk while it is written: kept, coalesced, locked, and whole after a full disk.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <stdexcept>

#include "editor/session/journal_writer.h"
#include "tests/session/test_scene.h"

namespace relievo::writer_test {
namespace {

long line_count(const std::filesystem::path& path) {
    const std::string text = test::read_text(path);
    return std::count(text.begin(), text.end(), '\n');
}

TEST(JournalWriter, LinesAreOnDiskBeforeItCloses) {
    const test::TemporaryFolder folder;
    JournalWriter writer(folder.path() / "a.jsonl", {});
    EXPECT_EQ(line_count(writer.path()), 1);
    writer.append(UndoOp{});
    EXPECT_EQ(line_count(writer.path()), 2);
}

TEST(JournalWriter, NeverOverwrites) {
    const test::TemporaryFolder folder;
    test::write_text(folder.path() / "a.jsonl", "precious");
    EXPECT_THROW(JournalWriter(folder.path() / "a.jsonl", {}), std::invalid_argument);
    EXPECT_EQ(test::read_text(folder.path() / "a.jsonl"), "precious");
    EXPECT_THROW(JournalWriter(folder.path() / "no" / "a.jsonl", {}), std::invalid_argument);
}

TEST(JournalWriter, DraggingASliderLeavesOneLine) {
    const test::TemporaryFolder folder;
    JournalWriter writer(folder.path() / "a.jsonl", {});
    for (double value : {0.5, 0.123456789, 0.25, 1.0}) writer.append(SetOp{"amplitude", value});
    writer.append(SetOp{"midlevel", 0.1});
    writer.append(UndoOp{});
    writer.append(SetOp{"midlevel", 0.2});
    writer.append(SetOp{"midlevel", 0.1234567});
    const Journal journal = read_journal(writer.path());
    ASSERT_EQ(journal.entries.size(), 4u);
    EXPECT_EQ(journal.entries[0].op, JournalOp(SetOp{"amplitude", 1.0}));
    EXPECT_EQ(journal.entries[1].op, JournalOp(SetOp{"midlevel", 0.1}));
    EXPECT_EQ(journal.entries[3].op, JournalOp(SetOp{"midlevel", 0.1234567}));
}

TEST(JournalWriter, AFullDiskKeepsLinesForLaterAndTearsNone) {
    const test::TemporaryFolder folder;
    std::signal(SIGXFSZ, SIG_IGN);
    JournalWriter writer(folder.path() / "a.jsonl", {});
    writer.append(UndoOp{});
    rlimit unlimited{};
    getrlimit(RLIMIT_FSIZE, &unlimited);
    const rlimit full{50, unlimited.rlim_max};
    setrlimit(RLIMIT_FSIZE, &full);
    writer.append(StrokeOp{Brush{}, {Dab{}, Dab{}}});
    writer.append(RedoOp{});
    setrlimit(RLIMIT_FSIZE, &unlimited);
    EXPECT_NE(writer.error().find("cannot write the journal"), std::string::npos) << writer.error();
    EXPECT_EQ(read_journal(writer.path()).entries.size(), 1u);
    writer.append(UndoOp{});
    EXPECT_EQ(writer.error(), "");
    const Journal journal = read_journal(writer.path());
    ASSERT_EQ(journal.entries.size(), 4u);
    EXPECT_TRUE(journal.warnings.empty());
    EXPECT_TRUE(std::holds_alternative<StrokeOp>(journal.entries[1].op));
    EXPECT_TRUE(std::holds_alternative<RedoOp>(journal.entries[2].op));
}

TEST(JournalWriter, ADeletedFileIsWrittenAnewWithAllItsLines) {
    const test::TemporaryFolder folder;
    JournalWriter writer(folder.path() / "a.jsonl", {});
    writer.append(StrokeOp{Brush{}, {Dab{}, Dab{}}});
    writer.append(SetOp{"amplitude", 0.5});
    std::filesystem::remove(writer.path());
    writer.append(SetOp{"amplitude", 0.25});
    std::filesystem::remove(writer.path());
    writer.append(UndoOp{});
    EXPECT_EQ(writer.error(), "");
    const Journal journal = read_journal(writer.path());
    ASSERT_EQ(journal.entries.size(), 3u);
    EXPECT_TRUE(std::holds_alternative<StrokeOp>(journal.entries[0].op));
    EXPECT_EQ(journal.entries[1].op, JournalOp(SetOp{"amplitude", 0.25}));
    EXPECT_EQ(journal.entries[2].op, JournalOp(UndoOp{}));
}

TEST(JournalWriter, ADeletedFolderIsReportedAndNoLineIsLostOnceItIsBack) {
    const test::TemporaryFolder folder;
    const auto inner = folder.path() / "inner";
    std::filesystem::create_directory(inner);
    JournalWriter writer(inner / "a.jsonl", {});
    writer.append(RedoOp{});
    std::filesystem::remove_all(inner);
    writer.append(SetOp{"amplitude", 0.25});
    writer.append(UndoOp{});
    EXPECT_NE(writer.error().find("cannot write the journal"), std::string::npos) << writer.error();
    std::filesystem::create_directory(inner);
    writer.append(RedoOp{});
    EXPECT_EQ(writer.error(), "");
    const Journal journal = read_journal(writer.path());
    ASSERT_EQ(journal.entries.size(), 4u);
    EXPECT_EQ(journal.entries[1].op, JournalOp(SetOp{"amplitude", 0.25}));
}

}  // namespace
}  // namespace relievo::writer_test
