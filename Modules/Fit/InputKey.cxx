#include "InputKey.h"

#include "ContentDigest.h"
#include "FileStamp.h"

namespace palpate
{
std::string KeyOfInputs(const std::vector<std::filesystem::path>& files,
                        const std::vector<std::string>& words)
{
  ContentDigest digest;
  for (const std::filesystem::path& file : files)
  {
    const bool isNone = file.empty();
    digest.Add(isNone ? "" : std::filesystem::absolute(file).lexically_normal().generic_string());
    digest.Add(isNone ? "" : StampOf(file));
  }
  for (const std::string& word : words)
  {
    digest.Add(word);
  }
  return digest.Text();
}
} // namespace palpate
