#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace palpate
{
/// A file's size in bytes. Throws InputError if it is missing, not a regular file, empty, or cannot
/// be opened.
std::uintmax_t InputFileSize(const std::filesystem::path& path);

/// All bytes of a file. Throws InputError if it is missing, not a regular file, empty, unreadable,
/// or larger than `maximumBytes`.
std::string ReadWholeFile(const std::filesystem::path& path, std::uintmax_t maximumBytes);

/// Writes all bytes, under AtomicFile's rules. Throws InputError.
void WriteWholeFile(const std::filesystem::path& path, std::string_view bytes);
/// The same for what `write` writes bit by bit, so that it need not be in memory.
void WriteWholeFile(const std::filesystem::path& path,
                    const std::function<void(std::ostream&)>& write);
} // namespace palpate
