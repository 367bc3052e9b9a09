#include "InputKey.h"

#include "ContentDigest.h"
#include "FileStamp.h"

namespace palpate
{
namespace
{
// Through links: --anonymous gives every run other ones.
std::filesystem::path RealPath(const std::filesystem::path& file)
{
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::absolute(file).lexically_normal();
  const std::filesystem::path real = std::filesystem::weakly_canonical(whole, error);
  return error ? whole : real;
}
} // namespace

std::string KeyOfInputs(const std::vector<std::filesystem::path>& files,
                        const std::vector<std::string>& words)
{
  ContentDigest digest;
  for (const std::filesystem::path& file : files)
  {
    const bool isNone = file.empty();
    digest.Add(isNone ? "" : RealPath(file).generic_string());
    digest.Add(isNone ? "" : StampOf(file));
  }
  for (const std::string& word : words)
  {
    digest.Add(word);
  }
  return digest.Text();
}
} // namespace palpate
