// PalpateCorrespondence [--repair] LABEL FILE...: how well surface models of masks and of their
// noisy, coarser and mirrored variants correspond; a line per file, and their summary.
#include "SurfaceCorrespondence.h"

#include "ImageIndexToWorld.h"
#include "LabelMask.h"
#include "SegmentationFile.h"

#include "vtkImageData.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>

namespace palpate::bench
{
namespace
{
PlacedLabel ReadLabel(const std::string& file, const std::string& label)
{
  const Segmentation segmentation = ReadSegmentation(file);
  const Segment& segment = segmentation.Find(label);
  vtkImageData* image = segmentation.Layers[static_cast<std::size_t>(segment.Layer)];
  return {CopyLabelMask(image, segment.Value, 1).Mask, IndexToWorldOf(image)};
}

struct Summary
{
  std::array<double, 3> Sum{};
  std::array<double, 3> Worst{}; // of the means of masks
  std::array<double, 3> Largest{};
  std::array<int, 3> Above{}; // masks whose mean is above 5 mm
  std::array<double, 3> Far{};
  int Count = 0;

  void Add(const SurfaceCorrespondence& correspondence)
  {
    constexpr double Disagreement = 5.0; // mm
    const auto all = correspondence.All();
    ++this->Count;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      this->Sum[i] += all[i].Mean;
      this->Worst[i] = std::max(this->Worst[i], all[i].Mean);
      this->Largest[i] = std::max(this->Largest[i], all[i].Largest);
      this->Above[i] += all[i].Mean > Disagreement ? 1 : 0;
      this->Far[i] += all[i].FarShare;
    }
  }
  void Print() const
  {
    const std::array<const char*, 3> names{"noise", "other grid", "mirror"};
    for (std::size_t i = 0; i < names.size(); ++i)
    {
      const double count = std::max(1, this->Count);
      std::printf(
          "%s: mean %.3f mm, worst of %d masks %.3f, above 5 mm %d; of places %.2f %% above "
          "5 mm, farthest %.2f\n",
          names[i], this->Sum[i] / count, this->Count, this->Worst[i], this->Above[i],
          100.0 * this->Far[i] / count, this->Largest[i]);
    }
  }
};
} // namespace
} // namespace palpate::bench

int main(int argc, char** argv)
{
  using namespace palpate::bench;
  const bool isRepaired = argc > 1 && std::string(argv[1]) == "--repair";
  const int first = isRepaired ? 2 : 1;
  if (argc < first + 2)
  {
    std::cerr << "usage: PalpateCorrespondence [--repair] LABEL FILE...\n";
    return 2;
  }
  try
  {
    Summary summary;
    for (int i = first + 1; i < argc; ++i)
    {
      SurfaceCorrespondence found;
      const palpate::Status status =
          MeasureCorrespondence(ReadLabel(argv[i], argv[first]), isRepaired, found);
      if (!status.IsOk())
      {
        std::printf("%s | %s\n", argv[i], status.Message().c_str());
        continue;
      }
      summary.Add(found);
      std::printf("%s | %.3f %.2f | %.3f %.2f | %.3f %.2f\n", argv[i], found.Noise.Mean,
                  found.Noise.Largest, found.Grid.Mean, found.Grid.Largest, found.Mirror.Mean,
                  found.Mirror.Largest);
      std::fflush(stdout);
    }
    summary.Print();
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
