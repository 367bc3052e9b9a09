#include "AtomicFile.h"

#include "Refusal.h"

#include <string>

namespace palpate
{
namespace
{
// File names may have 255 bytes; the longest ending in use is far shorter than this.
constexpr std::size_t KeptEnding = 32;

void RequireOutput(const Status& status, const std::filesystem::path& path)
{
  if (!status.IsOk())
  {
    Refuse(path, "cannot be written: " + status.Message(), "choose another output");
  }
}

std::string EndingOf(const std::filesystem::path& path)
{
  const std::string name = path.filename().string();
  return name.size() > KeptEnding ? name.substr(name.size() - KeptEnding) : name;
}
} // namespace

AtomicFile::AtomicFile(const std::filesystem::path& path) : Requested(path)
{
  RequireOutput(this->File.Create(path, ".palpate-", "-" + EndingOf(path)), path);
}

void AtomicFile::Commit()
{
  RequireOutput(this->File.Publish(), this->Requested);
}
} // namespace palpate
