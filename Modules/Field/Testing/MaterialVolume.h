#pragma once

#include "RandomVolume.h"

namespace palpate::test
{
/// A random volume of two channels and three materials, one of them within another.
class MaterialVolume
{
public:
  static constexpr int Materials = 3;

  explicit MaterialVolume(std::mt19937_64& random)
      : Grid(ObliqueGrid({2 + static_cast<int>(random() % 45), 2 + static_cast<int>(random() % 30),
                          2 + static_cast<int>(random() % 40)},
                         random)),
        First(RandomVolume::RandomSamples(Grid, random)), Second(RandomSteps(Grid, random, 4))
  {
  }

  std::shared_ptr<const ScalarField> Make(const FieldForm& form, bool keepsAll = false) const
  {
    FieldBuilder builder(this->Grid);
    const double iso = 0.5 * this->First.back();
    const int first = builder.AddChannel(SamplesOfGrid(this->First.data(), this->Grid));
    const int second = builder.AddChannel(SamplesOfGrid(this->Second.data(), this->Grid));
    builder.AddMaterial({first, iso});
    builder.AddMaterial({second, 1.0, FieldSense::AtMost});
    builder.AddMaterial({first, iso}, {second, 1.5});
    builder.SetForm(form);
    if (keepsAll)
    {
      builder.KeepAll();
    }
    std::shared_ptr<const ScalarField> field;
    const Status status = builder.Build(field);
    EXPECT_TRUE(status.IsOk()) << status.Message();
    return field;
  }

  FieldGrid Grid;
  std::vector<double> First;
  std::vector<double> Second;
};

/// In the grid, slightly outside, on its nodes and faces.
inline Vector3 RandomPointNear(const FieldGrid& grid, std::mt19937_64& random)
{
  Vector3 p;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double last = grid.Size()[static_cast<std::size_t>(axis)] - 1;
    const double any = std::uniform_real_distribution<double>(-0.5, last + 0.5)(random);
    p[axis] = random() % 2 == 0 ? any : std::round(any);
  }
  return p;
}
} // namespace palpate::test
