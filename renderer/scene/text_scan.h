// Reading text formats line by line: tokens, numbers, and how to quote them in messages.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace relievo {

// The whole file. Throws std::invalid_argument when it is missing, not a file, unreadable or empty.
std::string read_file(const std::filesystem::path& path);

// Cuts the first line (without its end, \n or \r\n) from `text`.
std::string_view next_line(std::string_view& text);
// Cuts the first token between blanks from `line`; empty at the end.
std::string_view next_token(std::string_view& line);

// The number that the whole token spells; "nan" and "inf" are numbers here, for the caller to refuse by name.
std::optional<double> parse_number(std::string_view token);
std::optional<std::int64_t> parse_integer(std::string_view token);

// The token in quotes, shortened to 40 characters, control characters as '?'.
std::string in_quotes(std::string_view token);

// A finite number, or std::invalid_argument with a message that starts with `where`.
double require_number(std::string_view token, const std::string& where);

}  // namespace relievo
