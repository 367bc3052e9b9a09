#include "SceneGrowth.h"

#include "ImageWriter.h"
#include "ResidentMemory.h"
#include "StructureStroke.h"
#include "TemporaryFolder.h"
#include "TouchRun.h"

#include "vtkImageData.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <malloc.h>

namespace palpate::bench
{
namespace
{
constexpr const char* Atlas = "/usr/share/mricron/templates/aal.nii.gz";
constexpr int AtlasStructures = 116;

bool GoOn(double, const std::string&)
{
  return true;
}

double Quantile(std::vector<double> values, double part)
{
  std::sort(values.begin(), values.end());
  const auto last = static_cast<double>(values.size() - 1);
  return values[static_cast<std::size_t>(std::lround(part * last))];
}

// Cubes of six voxels, eight apart, as labels from 1 on.
void WriteCubes(const std::filesystem::path& file, int count)
{
  constexpr int Apart = 8;
  constexpr int Inside = 6;
  const int row = static_cast<int>(std::ceil(std::cbrt(count)));
  vtkNew<vtkImageData> image;
  image->SetDimensions(Apart * row, Apart * row, Apart * row);
  image->AllocateScalars(VTK_UNSIGNED_SHORT, 1);
  auto* voxel = static_cast<unsigned short*>(image->GetScalarPointer());
  for (int k = 0; k < Apart * row; ++k)
  {
    for (int j = 0; j < Apart * row; ++j)
    {
      for (int i = 0; i < Apart * row; ++i)
      {
        const int number = (k / Apart * row + j / Apart) * row + i / Apart;
        const bool isInside = std::max({i % Apart, j % Apart, k % Apart}) < Inside;
        *voxel++ = static_cast<unsigned short>(isInside && number < count ? number + 1 : 0);
      }
    }
  }
  WriteImage(file, image);
}

// An entry a label.
SceneSettings SceneOfFile(const std::filesystem::path& file, int count, int touched)
{
  SceneSettings settings;
  for (int label = 1; label <= count; ++label)
  {
    SceneStructure structure;
    structure.File = file;
    structure.Labels = {std::to_string(label)};
    structure.IsVisible = false;
    structure.IsTouchable = label <= touched;
    settings.Structures.push_back(structure);
  }
  return settings;
}

SceneGrowthRow MeasureScene(const std::string& scene, const std::filesystem::path& file, int count,
                            int touched)
{
  const SceneSettings settings = SceneOfFile(file, count, touched);
  malloc_trim(0);
  const double before = test::ResidentMebibytes();
  BuiltScene made = BuildScene(settings, GoOn);
  SceneGrowthRow row{scene, count, touched, 0, 0.0, 0.0, 0, 0, 0.0, 0.0};
  for (const SceneFileAccount& read : made.Account.Files)
  {
    row.FilesRead += read.Reading.Is.empty() ? 0 : 1;
    row.ReadSeconds += read.Reading.Seconds;
  }
  for (const SceneStructureAccount& structure : made.Account.Structures)
  {
    row.Bytes += structure.Contact.Bytes;
    row.MakeSeconds += structure.Contact.Seconds;
  }
  row.ServoBytes = AccountForServo(made).Bytes;
  made.Account = {}; // which no touch keeps
  malloc_trim(0);
  row.ResidentMebibytes = test::ResidentMebibytes() - before;
  made = {};
  TouchScript script;
  script.Duration = 2.0;
  const TouchResult touch = RunTouch(PrepareTouch(settings, script, GoOn), {}, GoOn);
  row.TickMicroseconds = 1e-3 * static_cast<double>(touch.Durations.Median());
  return row;
}
} // namespace

std::vector<TickGrowthRow> MeasureTickGrowth()
{
  constexpr int Strokes = 20;
  constexpr double Rare = 0.999;
  std::vector<TickGrowthRow> rows;
  for (const int count : {1, 10, AtlasStructures, 10000, 100000})
  {
    const std::unique_ptr<ServoStroke> scene = StructureStroke(count);
    std::vector<double> ticks;
    for (int stroke = 0; stroke < Strokes; ++stroke)
    {
      scene->StrokeTimed(ticks);
    }
    rows.push_back({count, Quantile(ticks, 0.5), Quantile(ticks, Rare), Quantile(ticks, 1.0),
                    scene->PublishSeconds(), scene->BytesPerStructure()});
  }
  return rows;
}

std::vector<SceneGrowthRow> MeasureSceneGrowth()
{
  const test::TemporaryFolder folder;
  std::vector<SceneGrowthRow> rows;
  for (const int count : {1, 10, 10000})
  {
    const std::filesystem::path file = folder / ("cubes" + std::to_string(count) + ".nii");
    WriteCubes(file, count);
    rows.push_back(MeasureScene("cubes", file, count, 1));
  }
  if (std::filesystem::exists(Atlas))
  {
    rows.push_back(MeasureScene("AAL", Atlas, AtlasStructures, 1));
    rows.push_back(MeasureScene("AAL", Atlas, AtlasStructures, AtlasStructures));
  }
  return rows;
}
} // namespace palpate::bench
