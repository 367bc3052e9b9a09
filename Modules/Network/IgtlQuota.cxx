#include "IgtlQuota.h"

#include <locale>
#include <sstream>
#include <string>

namespace palpate
{
Status IgtlQuota::Check(std::uint64_t bytes) const
{
  constexpr double BytesPerGigabyte = 1e9;
  if (this->Kept >= this->MostImages)
  {
    return Status::Failure("The peer sends more than " + std::to_string(this->MostImages) +
                           " images");
  }
  const double total = static_cast<double>(this->Bytes) + static_cast<double>(bytes);
  if (total > this->Gigabytes * BytesPerGigabyte)
  {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << "The peer sends more than " << this->Gigabytes << " GB of voxels";
    return Status::Failure(text.str());
  }
  return Status::Success();
}

void IgtlQuota::Add(std::uint64_t bytes) noexcept
{
  ++this->Kept;
  this->Bytes += bytes;
}
} // namespace palpate
