#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace palpate
{
/// The only parser of JSON from files. Throws InputError, naming `file` and ending with `remedy`,
/// if the text is not JSON (with line and column), if lists and objects are nested more than 64
/// deep, which would overflow the stack of recursive code, if a number is too large, or if its
/// values would not fit into memory.
nlohmann::json ParseJson(std::string_view text, const std::filesystem::path& file,
                         const std::string& remedy);

/// The same with keys in the file's order. Refuses more than 10,000 keys: an ordered object is
/// searched from its start for each of them.
nlohmann::ordered_json ParseOrderedJson(std::string_view text, const std::filesystem::path& file,
                                        const std::string& remedy);

/// Parses a whole file of at most `maximumBytes`.
nlohmann::json ReadJson(const std::filesystem::path& file, std::uintmax_t maximumBytes,
                        const std::string& remedy);
} // namespace palpate
