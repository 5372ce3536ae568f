// Files for one test in a folder of its own, and the message that a call fails with.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace relievo {

class TestFiles : public testing::Test {
  protected:
    TestFiles() {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        std::string name = std::string(info->test_suite_name()) + "." + info->name();
        for (char& c : name) c = c == '/' ? '_' : c;
        folder_ = std::filesystem::path(testing::TempDir()) / (name + "." + std::to_string(::getpid()));
        std::filesystem::create_directories(folder_);
    }
    ~TestFiles() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
        return folder_ / name;
    }
    const std::filesystem::path& folder() const { return folder_; }

  private:
    std::filesystem::path folder_;
};

// What `call` throws as std::invalid_argument; "" and a failure when it does not.
template <class Call>
std::string refusal(Call&& call) {
    try {
        call();
    } catch (const std::invalid_argument& e) {
        return e.what();
    } catch (const std::exception& e) {
        ADD_FAILURE() << "not an invalid_argument: " << e.what();
        return e.what();
    }
    ADD_FAILURE() << "nothing was refused";
    return "";
}

inline const std::string kQuadObj =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";

}  // namespace relievo
