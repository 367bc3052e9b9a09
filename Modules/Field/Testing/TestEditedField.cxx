#include "DrilledCases.h"
#include "EditedField.h"
#include "FieldSampler.h"
#include "RandomRays.h"
#include "RayCaster.h"
#include "SameBits.h"

#include <atomic>
#include <thread>

namespace palpate::edited_field_test
{
namespace
{
using test::CutPath;
using test::Drill;
using test::SameBits;
using test::SamplesNow;
using test::ScannedBone;
using test::VersionOf;

class EditedFieldTest : public testing::Test
{
protected:
  std::mt19937_64 Random{31};
  ScannedBone Bone{
      {{50, 42, 34}, {3.0, -4.0, 5.0}, Vector3::Constant(0.6), test::RandomOrientation(Random)},
      8.0,
      0.7};
  const CutTool Tool = CutTool::Sphere(1.2);

  Vector3 RandomPlace()
  {
    std::uniform_real_distribution<double> part(-7.0, 7.0);
    return this->Bone.Center + Vector3(part(this->Random), part(this->Random), part(this->Random));
  }
  std::vector<FieldHit> HitsOf(const std::shared_ptr<const ScalarField>& field, int count) const
  {
    std::mt19937_64 random(7);
    const RayCaster caster(field);
    std::vector<FieldHit> hits;
    hits.reserve(static_cast<std::size_t>(count));
    for (int n = 0; n < count; ++n)
    {
      hits.push_back(caster.CastIndex(test::RandomRay(this->Bone.Grid, random), 0.0, 1e3));
    }
    return hits;
  }
};

bool AreSame(const std::vector<FieldHit>& a, const std::vector<FieldHit>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const FieldHit& x, const FieldHit& y) { return SameBits(x, y); });
}

TEST_F(EditedFieldTest, HeldVersionsKeepTheirBits)
{
  const auto drilled = Drill(*this->Bone.Make());
  struct Held
  {
    std::shared_ptr<const ScalarField> Version;
    std::vector<FieldHit> Hits;
  };
  std::vector<Held> held;
  for (int round = 0; round < 120; ++round)
  {
    CutPath(*drilled, this->Tool, this->RandomPlace(), this->RandomPlace());
    const auto version = VersionOf(*drilled);
    held.push_back({version, this->HitsOf(version, 60)});
    if (held.size() > 3)
    {
      held.erase(held.begin() + static_cast<std::ptrdiff_t>(this->Random() % held.size()));
    }
    for (const Held& one : held)
    {
      ASSERT_TRUE(AreSame(this->HitsOf(one.Version, 60), one.Hits));
    }
    if (round % 10 == 9)
    {
      drilled->Undo();
    }
  }
}

TEST_F(EditedFieldTest, VersionOutlivesItsField)
{
  auto drilled = Drill(*this->Bone.Make());
  CutPath(*drilled, this->Tool, this->Bone.Center, this->RandomPlace());
  const auto version = VersionOf(*drilled);
  const auto hits = this->HitsOf(version, 200);
  drilled.reset();
  EXPECT_TRUE(AreSame(this->HitsOf(version, 200), hits));
}

// However long the drilling: directories for the versions in use at once, and records of bricks.
TEST_F(EditedFieldTest, MemoryIsBoundedByBricksNotCuts)
{
  const auto drilled = Drill(*this->Bone.Make());
  drilled->SetHistoryBytes(0);
  std::shared_ptr<const ScalarField> used;
  std::size_t bytes = 0;
  for (int round = 0; round < 600; ++round)
  {
    const Vector3 place = this->RandomPlace();
    CutPath(*drilled, this->Tool, place, place);
    used = VersionOf(*drilled);
    if (round == 300)
    {
      bytes = drilled->Bytes();
    }
    if (round % 50 == 49)
    {
      drilled->Reset();
    }
  }
  EXPECT_LE(drilled->Bytes(), bytes + bytes / 4);
}

TEST_F(EditedFieldTest, RejectsTooManyVersionsUntilSomeAreReleased)
{
  const auto drilled = Drill(*this->Bone.Make());
  std::vector<std::shared_ptr<const ScalarField>> held;
  Status status = Status::Success();
  for (int round = 0; round < 500 && status.IsOk(); ++round)
  {
    CutPath(*drilled, this->Tool, this->RandomPlace(), this->RandomPlace());
    drilled->EndStroke();
    held.emplace_back();
    status = drilled->MakeVersion(held.back());
    if (round % 20 == 19)
    {
      drilled->Reset(); // restores the bone
    }
  }
  EXPECT_NE(status.Message().find("Too many versions"), std::string::npos);
  EXPECT_EQ(held.back(), nullptr);
  held.clear();
  const auto afresh = this->Bone.Make(SamplesNow(*drilled, this->Bone));
  EXPECT_TRUE(AreSame(this->HitsOf(VersionOf(*drilled), 300), this->HitsOf(afresh, 300)));
}

// No ray may leap over a surface; a surface that appears inside a filled region is found from afar.
TEST_F(EditedFieldTest, HitsANewSurfaceFarFromOthers)
{
  const FieldGrid grid = test::PlainGrid({130, 130, 130});
  std::vector<std::int8_t> samples(grid.NodeCount(), 1);
  samples[0] = 0;
  FieldBuilder builder(grid);
  builder.KeepInside(
      builder.AddMaterial({builder.AddChannel(SamplesOfGrid(samples.data(), grid)), 0.5}));
  std::shared_ptr<const ScalarField> field;
  ASSERT_TRUE(builder.Build(field).IsOk());
  const auto drilled = Drill(*field);
  const Vector3 middle(100.0, 90.0, 110.0);
  CutPath(*drilled, CutTool::Sphere(4.0), middle, middle);
  const auto version = VersionOf(*drilled);
  const RayCaster caster(version);
  for (int n = 0; n < 300; ++n)
  {
    const Vector3 from =
        Vector3::Constant(2.0) + 100.0 * test::RandomOrientation(this->Random).col(0).cwiseAbs();
    const FieldHit hit = caster.CastIndex({from, middle - from}, 0.0, 1.0);
    const double distance = (middle - from).norm();
    if (distance > 6.0)
    {
      ASSERT_EQ(hit.Kind, HitKind::Surface);
      ASSERT_NEAR((1.0 - hit.T) * distance, 4.0, 0.2);
    }
  }
}

// One thread cuts, others cast rays at published versions: each has the bits of a state between two
// cuts.
TEST_F(EditedFieldTest, OtherThreadsSeeNoTornVersion)
{
  const auto field = this->Bone.Make();
  constexpr int Cuts = 40;
  std::vector<Vector3> places;
  std::vector<std::vector<FieldHit>> expected;
  const auto alone = Drill(*field);
  for (int cut = 0; cut < Cuts; ++cut)
  {
    places.push_back(this->RandomPlace());
    CutPath(*alone, this->Tool, places.back(), places.back());
    expected.push_back(this->HitsOf(VersionOf(*alone), 40));
  }
  struct Slot
  {
    std::shared_ptr<const ScalarField> Version;
    int Cut = 0;
    std::atomic<bool> IsFull{false};
  };
  std::array<Slot, 2> slots;
  std::atomic<bool> isOver{false};
  std::atomic<int> wrong{0};
  std::atomic<int> seen{0};
  std::vector<std::thread> readers;
  readers.reserve(slots.size());
  for (Slot& slot : slots)
  {
    readers.emplace_back(
        [&, this]
        {
          while (!isOver || slot.IsFull)
          {
            if (!slot.IsFull.load(std::memory_order_acquire))
            {
              std::this_thread::yield();
              continue;
            }
            const auto version = std::move(slot.Version);
            const auto cut = static_cast<std::size_t>(slot.Cut);
            slot.IsFull.store(false, std::memory_order_release);
            wrong += AreSame(this->HitsOf(version, 40), expected[cut]) ? 0 : 1;
            ++seen;
          }
        });
  }
  const auto drilled = Drill(*field);
  for (int round = 0; round < 5 * Cuts; ++round)
  {
    const int cut = round % Cuts;
    if (cut == 0)
    {
      drilled->Reset();
    }
    const Vector3& place = places[static_cast<std::size_t>(cut)];
    CutPath(*drilled, this->Tool, place, place);
    const auto version = VersionOf(*drilled);
    Slot& slot = slots[static_cast<std::size_t>(round) % slots.size()];
    // Every fourth version is certain to be read; meanwhile the others are overwritten.
    while (round % 4 == 0 && slot.IsFull.load(std::memory_order_acquire))
    {
      std::this_thread::yield();
    }
    if (!slot.IsFull.load(std::memory_order_acquire))
    {
      slot.Version = version;
      slot.Cut = cut;
      slot.IsFull.store(true, std::memory_order_release);
    }
  }
  isOver = true;
  for (std::thread& reader : readers)
  {
    reader.join();
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GE(seen, 5 * Cuts / 4);
}
} // namespace
} // namespace palpate::edited_field_test
