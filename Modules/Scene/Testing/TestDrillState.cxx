#include "DrillState.h"

#include "DrillContextCases.h"
#include "InputError.h"

namespace palpate::drill_state_test
{
namespace
{
class DrillStateTest : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Context = test::BenchOf(this->Files.Scene());
    test::ContextCuts(this->Context).CutAtRandom(this->Random, 12);
    WriteDrillState(this->Path, *this->Context);
  }
  std::string Refusal(const std::filesystem::path& path, const DrillContext& context) const
  {
    try
    {
      ReadDrillState(path, context);
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
  std::shared_ptr<DrillContext> Context;
};

TEST_F(DrillStateTest, RestoresEachOfSeveralStructures)
{
  SceneSettings settings = this->Files.Scene();
  settings.Structures.push_back(this->Files.SceneOfLabels().Structures[0]);
  const auto context = test::BenchOf(settings);
  test::ContextCuts cuts(context);
  cuts.Cut(Vector3(4.0, 0.0, 0.0), Vector3(5.0, 0.0, 0.0), 0);
  cuts.Cut(Vector3(0.0, 4.0, 0.0), Vector3(0.0, 6.0, 0.0), 1);
  WriteDrillState(this->Path, *context);
  const auto other = test::BenchOf(settings);
  ReadDrillState(this->Path, *other);
  EXPECT_EQ(test::StateOf(*other, 0), test::StateOf(*context, 0));
  EXPECT_EQ(test::StateOf(*other, 1), test::StateOf(*context, 1));
  std::swap(settings.Structures[0], settings.Structures[1]);
  EXPECT_NE(this->Refusal(this->Path, *test::BenchOf(settings)).find("other voxels"),
            std::string::npos);
}

TEST_F(DrillStateTest, RestoredStateRespectsNewProtection)
{
  const auto guarded = test::BenchOf(this->Files.SceneWithNerve());
  ReadDrillState(this->Path, *guarded);
  EXPECT_LT(guarded->Editor().RemovedVolumes()[0], this->Context->Editor().RemovedVolumes()[0]);
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
} // namespace palpate::drill_state_test
