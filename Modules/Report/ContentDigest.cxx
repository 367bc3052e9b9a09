#include "ContentDigest.h"

#include "Refusal.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <vector>

namespace palpate
{
void ContentDigest::AddBytes(std::string_view bytes)
{
  for (const char byte : bytes)
  {
    this->Hash = (this->Hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  }
}

void ContentDigest::Add(std::string_view piece)
{
  // The length first, so that different lists give different bytes.
  this->AddBytes(std::to_string(piece.size()) + ":");
  this->AddBytes(piece);
}

void ContentDigest::AddContent(const std::filesystem::path& path)
{
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
  {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(path, ignored))
    {
      files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    for (const std::filesystem::path& file : files)
    {
      if (std::filesystem::is_regular_file(file, ignored))
      {
        this->Add(file.filename().string());
        this->AddContent(file);
      }
    }
    return;
  }
  constexpr std::size_t Part = std::size_t{1} << 16U;
  std::vector<char> part(Part);
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
  {
    Refuse(path, "cannot be read", "check its name and permissions");
  }
  while (stream)
  {
    stream.read(part.data(), static_cast<std::streamsize>(part.size()));
    this->AddBytes({part.data(), static_cast<std::size_t>(stream.gcount())});
  }
  this->Add({});
}

std::string ContentDigest::Text() const
{
  std::array<char, 17> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx",
                static_cast<unsigned long long>(this->Hash));
  return digits.data();
}
} // namespace palpate
