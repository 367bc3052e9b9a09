#include "DrillState.h"

#include "DrillBenchCases.h"
#include "InputError.h"

namespace palpate
{
namespace
{
class DrillStateTest : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Bench = test::BenchOf(this->Files.Scene());
    test::BenchCuts(this->Bench).CutAtRandom(this->Random, 12);
    WriteDrillState(this->Path, *this->Bench);
  }
  std::string Refusal(const std::filesystem::path& path, const DrillBench& bench) const
  {
    try
    {
      ReadDrillState(path, bench);
    }
    catch (const InputError& error)
    {
      return error.what();
    }
    return {};
  }

  std::mt19937_64 Random{72};
  test::BoneFiles Files;
  std::filesystem::path Path = Files.Folder / "a.drill";
  std::shared_ptr<DrillBench> Bench;
};

TEST_F(DrillStateTest, RestoresEachOfSeveralStructures)
{
  SceneSettings settings = this->Files.Scene();
  settings.Structures.push_back(this->Files.SceneOfLabels().Structures[0]);
  const auto bench = test::BenchOf(settings);
  test::BenchCuts cuts(bench);
  cuts.Cut(Vector3(4.0, 0.0, 0.0), Vector3(5.0, 0.0, 0.0), 0);
  cuts.Cut(Vector3(0.0, 4.0, 0.0), Vector3(0.0, 6.0, 0.0), 1);
  WriteDrillState(this->Path, *bench);
  const auto other = test::BenchOf(settings);
  ReadDrillState(this->Path, *other);
  EXPECT_EQ(test::StateOf(*other, 0), test::StateOf(*bench, 0));
  EXPECT_EQ(test::StateOf(*other, 1), test::StateOf(*bench, 1));
  std::swap(settings.Structures[0], settings.Structures[1]);
  EXPECT_NE(this->Refusal(this->Path, *test::BenchOf(settings)).find("other voxels"),
            std::string::npos);
}

TEST_F(DrillStateTest, RestoredStateRespectsNewProtection)
{
  const auto guarded = test::BenchOf(this->Files.SceneWithNerve());
  ReadDrillState(this->Path, *guarded);
  EXPECT_LT(guarded->Editor().RemovedVolumes()[0], this->Bench->Editor().RemovedVolumes()[0]);
}

TEST_F(DrillStateTest, RejectsChangedVoxelAndMoreStructures)
{
  static_cast<short*>(this->Files.Ct->GetScalarPointer())[20000] += 1;
  WriteImage(this->Files.CtPath, this->Files.Ct);
  const auto changed = test::BenchOf(this->Files.Scene());
  EXPECT_NE(this->Refusal(this->Path, *changed).find("other voxels"), std::string::npos);
  EXPECT_EQ(changed->Editor().RemovedVolumes()[0], 0.0);
  SceneSettings two = this->Files.Scene();
  two.Structures.push_back(this->Files.SceneOfLabels().Structures[0]);
  EXPECT_NE(this->Refusal(this->Path, *test::BenchOf(two)).find("1 drilled"), std::string::npos);
}
} // namespace
} // namespace palpate
