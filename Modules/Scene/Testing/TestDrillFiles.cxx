#include "DrillBlock.h"
#include "DrillExport.h"
#include "DrillState.h"
#include "InputError.h"
#include "RemovalBytes.h"
#include "SurfaceFile.h"
#include "WholeFile.h"

#include "vtkDataArray.h"
#include "vtkMassProperties.h"
#include "vtkPointData.h"

#include <random>

namespace palpate::drill_files_test
{
namespace
{
using test::DrillBlock;

class DrillFiles : public testing::Test
{
protected:
  PreparedTouch Fresh() { return test::Prepare(this->Block.Settings(), DrillBlock::CanalAt(4.0)); }
  PreparedTouch Drilled()
  {
    const PreparedTouch touch = this->Fresh();
    this->Removed = RunTouch(touch, {}, test::NeverCancels).RemovedVolumes[0];
    return touch;
  }
  std::string Refusal(const PreparedTouch& touch)
  {
    try
    {
      ReadDrillState(this->File, *touch.Drill);
    }
    catch (const InputError& error)
    {
      return error.what();
    }
    return {};
  }

  DrillBlock Block;
  std::filesystem::path File = Block.Folder / "drill.state";
  double Removed = 0.0; // mm^3
};

std::vector<std::byte> StateOf(const PreparedTouch& touch)
{
  return BytesOf(*touch.Drill->Editor().Removed()[0]);
}

TEST_F(DrillFiles, StateRoundTripsBitForBit)
{
  const PreparedTouch touch = this->Drilled();
  WriteDrillState(this->File, *touch.Drill);
  const PreparedTouch again = this->Fresh();
  ReadDrillState(this->File, *again.Drill);
  EXPECT_EQ(StateOf(again), StateOf(touch));
  EXPECT_EQ(again.Drill->Editor().RemovedVolumes()[0], this->Removed);
}

TEST_F(DrillFiles, RejectsDamagedState)
{
  WriteDrillState(this->File, *this->Drilled().Drill);
  const std::string whole = ReadWholeFile(this->File, 1 << 28);
  const PreparedTouch touch = this->Fresh();
  std::mt19937_64 random(31);
  for (int n = 0; n < 200; ++n)
  {
    std::string bytes = whole;
    if (n % 2 == 0)
    {
      bytes.resize(1 + random() % (whole.size() - 1));
    }
    else
    {
      char& one = bytes[random() % (n % 4 == 1 ? whole.size() : 200)];
      one = static_cast<char>(one ^ static_cast<char>(1 << random() % 8));
    }
    WriteWholeFile(this->File, bytes);
    const std::string refusal = this->Refusal(touch);
    // A structure's name is for display only; it may differ.
    EXPECT_TRUE(!refusal.empty() || StateOf(touch).size() > 100) << n;
    EXPECT_TRUE(refusal.empty() || refusal.find(this->File.string()) == 0) << refusal;
  }
}

TEST_F(DrillFiles, RejectsStateOfOtherVoxels)
{
  WriteDrillState(this->File, *this->Drilled().Drill);
  SceneSettings settings = this->Block.Settings();
  settings.Structures[0].File = this->Block.Nerve;
  settings.Structures[0].Iso.reset();
  const PreparedTouch other = test::Prepare(settings, DrillBlock::CanalAt(4.0));
  EXPECT_EQ(
      this->Refusal(other),
      this->File.string() +
          " was drilled in other voxels than those of bone; open the scene that was drilled.");
}

TEST_F(DrillFiles, VolumeDiffersFromTheScanOnlyWhereDrilled)
{
  const PreparedTouch touch = this->Drilled();
  const auto image = DrilledImage(*touch.Drill, 0, test::NeverCancels);
  vtkImageData* const scan = touch.Drill->Sites()[0].Source.Image;
  vtkDataArray* const now = image->GetPointData()->GetScalars();
  vtkDataArray* const before = scan->GetPointData()->GetScalars();
  ASSERT_EQ(now->GetDataType(), VTK_SHORT);
  int changed = 0;
  for (vtkIdType n = 0; n < now->GetNumberOfTuples(); ++n)
  {
    ASSERT_LE(now->GetComponent(n, 0), before->GetComponent(n, 0));
    const bool isBelow = scan->GetPoint(n)[2] < 1.0; // farther from the canal than any ramp
    ASSERT_TRUE(!isBelow || now->GetComponent(n, 0) == before->GetComponent(n, 0));
    changed += now->GetComponent(n, 0) < before->GetComponent(n, 0) ? 1 : 0;
  }
  EXPECT_GT(changed, 100);
}

double VolumeOf(vtkPolyData* surface)
{
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(surface);
  return mass->GetVolume();
}

TEST_F(DrillFiles, SurfaceEnclosesWhatIsNotRemoved)
{
  const double whole = VolumeOf(DrilledSurface(*this->Fresh().Drill, 0, test::NeverCancels));
  EXPECT_NEAR(whole, 14.0 * 14.0 * 11.0, 0.01 * 14.0 * 14.0 * 11.0);
  const PreparedTouch touch = this->Drilled();
  const auto surface = DrilledSurface(*touch.Drill, 0, test::NeverCancels);
  EXPECT_NEAR(whole - VolumeOf(surface), this->Removed, 0.02 * this->Removed);
  const std::filesystem::path file = this->Block.Folder / "left.stl";
  WriteSurface(file, surface);
  EXPECT_NEAR(VolumeOf(ReadSurface(file)), VolumeOf(surface), 1e-3 * whole);
}

TEST_F(DrillFiles, DrilledLabelVoxelsLoseTheirLabel)
{
  SceneSettings settings = this->Block.Settings();
  settings.Structures[0].File = this->Block.Nerve;
  settings.Structures[0].Iso.reset();
  TouchScript script = DrillBlock::CanalAt(2.0);
  const PreparedTouch touch = test::Prepare(settings, script);
  const double removed = RunTouch(touch, {}, test::NeverCancels).RemovedVolumes[0];
  ASSERT_GT(removed, 0.3);
  const auto image = DrilledImage(*touch.Drill, 0, test::NeverCancels);
  vtkDataArray* const now = image->GetPointData()->GetScalars();
  vtkDataArray* const before = touch.Drill->Sites()[0].Source.Image->GetPointData()->GetScalars();
  int gone = 0;
  for (vtkIdType n = 0; n < now->GetNumberOfTuples(); ++n)
  {
    gone += now->GetComponent(n, 0) < before->GetComponent(n, 0) ? 1 : 0;
  }
  constexpr double Voxel = DrillBlock::Spacing * DrillBlock::Spacing * DrillBlock::Spacing;
  EXPECT_NEAR(gone * Voxel, removed, 0.3 * removed); // whole voxels of a small hole
}
} // namespace
} // namespace palpate::drill_files_test
