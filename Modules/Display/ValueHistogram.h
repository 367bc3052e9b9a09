#pragma once

#include "PalpateDisplayModule.h"

#include <cstddef>
#include <vector>

class vtkImageData;

namespace palpate
{
/// How often the values of an image occur, for charts and for the choice of a threshold.
struct ValueHistogram
{
  double Lowest = 0.0;  ///< of all counted values
  double Highest = 0.0; ///< at least Lowest
  /// The range of the counts: without the outermost thousandth of the values at either end, which
  /// padding and metal would stretch it by. Values beyond are in the first and last count.
  double First = 0.0;
  double Last = 1.0; ///< above First
  std::vector<std::size_t> Counts;

  /// The start of a bin; `bin` may be the number of bins.
  double ValueAt(std::size_t bin) const
  {
    return this->First + (this->Last - this->First) * static_cast<double>(bin) /
                             static_cast<double>(this->Counts.size());
  }
};

/// Of an evenly spread sample of at most 262,144 finite voxels (first component), so that it takes
/// milliseconds for images of any size. Without any such voxel the counts are 0.
PALPATEDISPLAY_EXPORT ValueHistogram HistogramOf(vtkImageData* image, int bins = 256);

/// The value that separates the counts into two classes with the greatest variance between them
/// (Otsu, IEEE Transactions on Systems, Man, and Cybernetics 9, 1979), in the middle of a gap
/// between both. First if all counts are in one bin.
PALPATEDISPLAY_EXPORT double OtsuThreshold(const ValueHistogram& histogram);

/// Whether the values may be those of a CT, in Hounsfield units: air is below -500, where no other
/// modality has values.
PALPATEDISPLAY_EXPORT bool LooksLikeCt(const ValueHistogram& histogram);
} // namespace palpate
