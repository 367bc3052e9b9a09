// The servo with the real contact models: a hand strokes a sphere of 15 mm of each kind.
#include "FieldContactCases.h"
#include "MeshCases.h"
#include "OrganContact.h"
#include "RecordedSession.h"
#include "TouchReplay.h"

#include <algorithm>
#include <functional>
#include <string>

namespace palpate::touch_models_test
{
namespace
{
constexpr double Radius = 15.0; // mm

std::shared_ptr<const RadialModel> SphereBody()
{
  std::vector<double> coefficients(25, 0.0);
  coefficients[0] = Radius * std::sqrt(4.0 * M_PI);
  return std::make_shared<RadialModel>(4, coefficients, Vector3::Zero());
}

std::shared_ptr<const ContactModel> Harmonic(RadialContactMode mode)
{
  std::shared_ptr<const ContactModel> contact;
  const Status status = MakeOrganContact(SphereBody(), mode, contact);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return contact;
}

std::shared_ptr<const ScalarField> SphereField()
{
  const FieldGrid grid({81, 81, 81}, Vector3::Constant(-20.0), Vector3::Constant(0.5),
                       Matrix3::Identity());
  // In index coordinates.
  const test::SphereField sphere{Vector3::Constant(40.0), Radius / 0.5};
  return test::SampledField(grid, sphere);
}

struct ModelCase
{
  std::string Name;
  std::function<std::shared_ptr<const ContactModel>()> Make;
  double DepthTolerance; // mm
  bool HasFriction;
};

void PrintTo(const ModelCase& c, std::ostream* stream)
{
  *stream << c.Name;
}

std::vector<ModelCase> AllModels()
{
  return {
      {"RadialNearest", [] { return Harmonic(RadialContactMode::Nearest); }, 1e-6, true},
      {"RadialByRadius", [] { return Harmonic(RadialContactMode::Radial); }, 1e-6, false},
      // Facets of 4,002 corners lie up to 0.02 mm inside the sphere.
      {"Facets", [] { return test::FacetContact(test::MeshOf(*SphereBody(), 20)); }, 0.03, true},
      // Trilinear between voxels of 0.5 mm, and a sphere of points instead of one.
      {"FieldProxy", [] { return test::FieldContact(SphereField()); }, 0.05, true},
      // The published law averages over all points in contact.
      {"FieldShell", [] { return test::PublishedContact(SphereField()); }, 1.0, false}};
}

class TouchModels : public testing::TestWithParam<ModelCase>
{
protected:
  // Descends on the sphere's top, 1 to 2 mm deep, and strokes over it in circles.
  static SimulatedSettings Stroking()
  {
    SimulatedSettings device;
    device.Path = [](double t)
    {
      const double angle = std::min(t, 0.5) * std::sin(4.0 * t);
      const double depth = t < 0.3 ? -2.0 : 1.5 + 0.5 * std::sin(11.0 * t);
      const Vector3 direction(std::sin(angle), 0.5 * std::sin(angle), std::cos(angle));
      return Vector3((Radius + 1.0 - depth) * direction.normalized());
    };
    return device;
  }

  TouchScene Scene(const SurfaceFriction& friction) const
  {
    TouchScene scene;
    scene.Tool = ToolShape::Sphere(1.0);
    scene.Structures.push_back({"sphere", GetParam().Make(), {0.8, 0.0005}, friction});
    return scene;
  }
};

TEST_P(TouchModels, PushOutwardsByDepth)
{
  test::SimulatedTouch touch(this->Scene({}), Stroking());
  int touched = 0;
  for (int n = 0; n < 3000; ++n)
  {
    const TouchState& state = touch.Tick();
    ASSERT_EQ(state.Safety.Fault, SafetyFault::None) << Describe(state.Safety.Fault);
    const Vector3 probe = state.ProbeWorld;
    const double depth = Radius + 1.0 - probe.norm();
    // After fading in, and at least a count from the surface.
    if (n > 1000 && depth > 0.1)
    {
      ++touched;
      ASSERT_NEAR(state.Depth, depth, GetParam().DepthTolerance);
      // Along the sphere's radius, except for voxels, facets and the slew of the strokes: 15
      // degrees.
      ASSERT_GT(Vector3(state.ForceWorld).normalized().dot(probe.normalized()), 0.965);
    }
  }
  EXPECT_GT(touched, 1000);
}

TEST_P(TouchModels, ReplayBitForBit)
{
  const SurfaceFriction friction =
      GetParam().HasFriction ? SurfaceFriction{0.4, 0.3} : SurfaceFriction{};
  const auto scene = std::make_shared<TouchScene>(this->Scene(friction));
  test::SimulatedTouch touch(*scene, Stroking());
  auto recording = std::make_shared<TouchRecording>();
  recording->Session = test::SessionOf(touch.Device, ServoSettings());
  for (int n = 0; n < 2000; ++n)
  {
    recording->Ticks.push_back(touch.Tick());
  }
  EXPECT_GE(recording->Ticks.back().Structure, 0);
  ReplayComparison comparison;
  ASSERT_TRUE(ReplayTouch(recording, {scene}, comparison).IsOk());
  EXPECT_EQ(comparison.Ticks, 2000u);
  EXPECT_EQ(comparison.DifferentTicks, 0u);
}

INSTANTIATE_TEST_SUITE_P(All, TouchModels, testing::ValuesIn(AllModels()),
                         [](const auto& chosen) { return chosen.param.Name; });
} // namespace
} // namespace palpate::touch_models_test
