#include "ImageReading.h"

#include "InputError.h"
#include "LabelStatistics.h"
#include "SegmentationFile.h"
#include "VolumeFile.h"

namespace palpate::test
{
void ReadImage(const std::filesystem::path& path)
{
  bool isVolume = true;
  try
  {
    ReadVolume(path);
  }
  catch (const InputError&)
  {
    isVolume = false;
  }
  try
  {
    MeasureLabels(ReadSegmentation(path));
  }
  catch (const InputError&)
  {
    if (!isVolume)
    {
      throw;
    }
  }
}
} // namespace palpate::test
