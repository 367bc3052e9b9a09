#pragma once

#include "Status.h"

#include <cstdint>

namespace palpate
{
/// How many images, and how many bytes of voxels, a program keeps of those that peers send: a peer
/// must not fill a disk.
class IgtlQuota
{
public:
  static constexpr int UsualImages = 1000;
  static constexpr double UsualGigabytes = 10.0; ///< of 1e9 bytes

  explicit IgtlQuota(int images = UsualImages, double gigabytes = UsualGigabytes)
      : MostImages(images), Gigabytes(gigabytes)
  {
  }

  /// Fails, naming the limit, if one more image with so many bytes of voxels is beyond it.
  Status Check(std::uint64_t bytes) const;
  /// Such an image was kept.
  void Add(std::uint64_t bytes) noexcept;
  int Images() const noexcept { return this->Kept; } ///< that were kept

private:
  int MostImages;
  double Gigabytes;
  int Kept = 0;
  std::uint64_t Bytes = 0;
};
} // namespace palpate
