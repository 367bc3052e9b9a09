#include "Handles.h"
#include "IcosahedronDirections.h"
#include "RandomShapes.h"
#include "ShapePriorFile.h"
#include "TemporaryFolder.h"
#include "Vector3.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace palpate::model_handle_test
{
namespace
{
using test::Owned;

RadialModel Bumpy()
{
  test::Random random(5);
  return test::RandomOrgan(random, 8);
}

Owned<palpate_model> HandleOf(const RadialModel& model)
{
  palpate_error error{};
  Owned<palpate_model> handle(palpate_model_create(model.Degree(), model.Coefficients().data(),
                                                   model.CenterWorld().data(), &error));
  EXPECT_NE(handle, nullptr) << error.text;
  return handle;
}

std::vector<double> CoefficientsOf(const palpate_model* model)
{
  std::vector<double> values(palpate_model_coefficients(model, nullptr, 0));
  EXPECT_EQ(palpate_model_coefficients(model, values.data(), values.size()), values.size());
  return values;
}

TEST(ModelHandle, CompletesABallFromItsCorners)
{
  std::vector<double> points;
  const IcosahedronDirections corners(1);
  for (const Vector3& direction : corners.Directions())
  {
    const Vector3 point = Vector3(5.0, 6.0, 7.0) + 24.0 * direction;
    points.insert(points.end(), point.begin(), point.end());
  }
  palpate_error error{};
  std::vector<double> deviations(palpate_mesh_point_count(8), -1.0);
  std::vector<double> next(18, -1.0);
  const Owned<palpate_model> made(palpate_complete(points.data(), nullptr, nullptr, nullptr, 12,
                                                   nullptr, 0.5, nullptr, deviations.data(),
                                                   next.data(), &error));
  ASSERT_NE(made, nullptr) << error.text;
  double volume = 0.0;
  double area = 0.0;
  ASSERT_EQ(palpate_model_measure(made.get(), &volume, &area, &error), 1);
  EXPECT_NEAR(volume, 4.0 / 3.0 * M_PI * std::pow(24.0, 3), 30.0); // 0.01 mm of radius
  EXPECT_GT(*std::min_element(deviations.begin(), deviations.end()), 0.3);
  EXPECT_NEAR(std::hypot(next[0] - 5.0, next[1] - 6.0, next[2] - 7.0), 24.0, 0.1);
  EXPECT_EQ(palpate_complete(points.data(), nullptr, nullptr, nullptr, 12, "absent.json", 0.5,
                             nullptr, nullptr, nullptr, &error),
            nullptr);
  EXPECT_NE(std::string(error.text).find("absent.json"), std::string::npos);
}

TEST(ModelHandle, CompletesASurfaceModelGivenTheOtherOrgan)
{
  // Bodies of 8 to 12 mm in ones of twice that.
  std::vector<SurfacePrior::Case> cases;
  for (int n = 0; n < 5; ++n)
  {
    const RadialModel body(0, {(8.0 + n) / ShapePrior::ConstantHarmonic}, Vector3::Zero());
    LogSurface known{Eigen::VectorXd::Zero(169), Vector3::Zero()};
    known.Coefficients[0] = std::log(16.0 + 2.0 * n) / ShapePrior::ConstantHarmonic;
    cases.push_back({SurfaceModel::FromModel(body), Vector3(0.0, 4.0, 0.0), known});
  }
  SurfacePrior prior;
  ASSERT_TRUE(SurfacePrior::OfGroup(cases, prior).IsOk());
  const test::TemporaryFolder folder;
  const std::string file = (folder / "prior.json").string();
  WriteShapePrior(prior, file);
  palpate_error error{};
  const double sizes[] = {22.0 / ShapePrior::ConstantHarmonic};
  const double center[] = {50.0, 0.0, 0.0};
  const Owned<palpate_model> gland(palpate_model_create(0, sizes, center, &error));
  std::vector<double> deviations(palpate_mesh_point_count(8), -1.0);
  std::vector<double> next(18, 0.0);
  const double none = 0.0;
  const Owned<palpate_model> made(palpate_complete_organ(&none, nullptr, nullptr, nullptr, 0,
                                                         file.c_str(), 1.0, nullptr, gland.get(),
                                                         deviations.data(), next.data(), &error));
  ASSERT_NE(made, nullptr) << error.text;
  EXPECT_EQ(palpate_model_is_radial(made.get()), 0);
  double volume = 0.0;
  double area = 0.0;
  ASSERT_EQ(palpate_model_measure(made.get(), &volume, &area, &error), 1);
  // 11 mm, which the ridge draws towards the mean of 10.
  EXPECT_NEAR(std::cbrt(0.75 * volume / M_PI), 11.0, 0.15);
  EXPECT_GT(*std::min_element(deviations.begin(), deviations.end()), 0.3);
  EXPECT_NEAR(std::hypot(next[0] - 50.0, next[1] - 4.0, next[2]), 11.0, 0.5);
  EXPECT_EQ(palpate_complete_organ(&none, nullptr, nullptr, nullptr, 0, nullptr, 1.0, nullptr,
                                   gland.get(), nullptr, nullptr, &error),
            nullptr);
  EXPECT_NE(std::string(error.text).find("no other organ"), std::string::npos);
}

TEST(ModelHandle, PointsAreThoseOfTheModel)
{
  const RadialModel model = Bumpy();
  const auto handle = HandleOf(model);
  EXPECT_EQ(palpate_model_degree(handle.get()), 8);
  EXPECT_EQ(palpate_model_is_radial(handle.get()), 1);
  EXPECT_EQ(palpate_model_yields(handle.get()), 0);
  EXPECT_EQ(CoefficientsOf(handle.get()), model.Coefficients());
  const Vector3 direction = Vector3(1.0, -2.0, 0.5);
  Vector3 point;
  Vector3 normal;
  ASSERT_EQ(
      palpate_model_point(handle.get(), direction.data(), point.data(), normal.data(), nullptr), 1);
  EXPECT_EQ(point, model.PointWorld(direction.stableNormalized()));
  EXPECT_EQ(normal, model.Normal(direction.stableNormalized()));
}

TEST(ModelHandle, FitRestoresTheCoefficients)
{
  const RadialModel model = Bumpy();
  std::vector<double> points;
  const IcosahedronDirections sphere(10);
  for (const Vector3& direction : sphere.Directions())
  {
    const Vector3 point = model.PointWorld(direction);
    points.insert(points.end(), point.data(), point.data() + 3);
  }
  palpate_error error{};
  const Owned<palpate_model> fitted(
      palpate_model_fit(points.data(), points.size() / 3, model.CenterWorld().data(), 8, &error));
  ASSERT_NE(fitted, nullptr) << error.text;
  const std::vector<double> found = CoefficientsOf(fitted.get());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_NEAR(found[i], model.Coefficients()[i], 1e-10);
  }
  EXPECT_EQ(palpate_model_fit(points.data(), 3, model.CenterWorld().data(), 8, &error), nullptr);
  EXPECT_NE(std::strlen(error.text), 0U);
}

// A box of 20 x 24 x 16 mm in voxels of 1, 1.5 and 2 mm, along y, z and x of the world.
TEST(ModelHandle, FitToAMaskHasItsBody)
{
  const int size[3] = {30, 24, 12};
  std::vector<uint8_t> inside(30 * 24 * 12, 0);
  for (std::size_t k = 2; k < 10; ++k)
  {
    for (std::size_t j = 4; j < 20; ++j)
    {
      std::fill_n(inside.begin() + static_cast<std::ptrdiff_t>((k * 24 + j) * 30 + 5), 20, 255);
    }
  }
  const double origin[3] = {100.0, 200.0, 300.0};
  const double spacing[3] = {1.0, 1.5, 2.0};
  const double axes[9] = {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0};
  palpate_error error{};
  for (const int isRadial : {0, 1})
  {
    const Owned<palpate_model> model(
        palpate_model_fit_mask(inside.data(), size, origin, spacing, axes, 16, isRadial, &error));
    ASSERT_NE(model, nullptr) << error.text;
    EXPECT_EQ(palpate_model_is_radial(model.get()), isRadial);
    palpate_body body;
    ASSERT_EQ(palpate_model_body(model.get(), &body, &error), 1) << error.text;
    EXPECT_NEAR(body.volume / (20.0 * 24.0 * 16.0), 1.0, 0.02) << "corners are round";
    EXPECT_NEAR(body.centroid[0], 100.0 + 11.0, 0.2);
    EXPECT_NEAR(body.centroid[1], 200.0 + 14.5, 0.2);
    EXPECT_NEAR(body.centroid[2], 300.0 + 17.25, 0.2);
  }
  const double skewed[9] = {0.0, 1.0, 0.0, 0.0, 0.6, 0.8, 1.0, 0.0, 0.0};
  EXPECT_EQ(palpate_model_fit_mask(inside.data(), size, origin, spacing, skewed, 16, 0, &error),
            nullptr);
  inside.assign(inside.size(), 0);
  EXPECT_EQ(palpate_model_fit_mask(inside.data(), size, origin, spacing, axes, 16, 0, &error),
            nullptr);
  EXPECT_STREQ(error.text, "the mask has no voxels");
}

// SPHARM-PDM's format has surface models only: the other kind of model.
TEST(ModelHandle, FilesBringModelsBack)
{
  const test::TemporaryFolder folder;
  const auto handle = HandleOf(Bumpy());
  palpate_error error{};
  const std::string json = folder.Path() / "model.json";
  const std::string coef = folder.Path() / "model.coef";
  ASSERT_EQ(palpate_model_write(handle.get(), json.c_str(), &error), 1) << error.text;
  ASSERT_EQ(palpate_model_write(handle.get(), coef.c_str(), &error), 1) << error.text;
  const Owned<palpate_model> star(palpate_model_read(json.c_str(), &error));
  ASSERT_NE(star, nullptr) << error.text;
  EXPECT_EQ(CoefficientsOf(star.get()), CoefficientsOf(handle.get()));
  const Owned<palpate_model> surfaceModel(palpate_model_read(coef.c_str(), &error));
  ASSERT_NE(surfaceModel, nullptr) << error.text;
  EXPECT_EQ(palpate_model_is_radial(surfaceModel.get()), 0);
  EXPECT_EQ(CoefficientsOf(surfaceModel.get()).size(), 300U);
  double volumes[2];
  double areas[2];
  ASSERT_EQ(palpate_model_measure(star.get(), volumes, areas, &error), 1) << error.text;
  ASSERT_EQ(palpate_model_measure(surfaceModel.get(), volumes + 1, areas + 1, &error), 1);
  EXPECT_NEAR(volumes[1] / volumes[0], 1.0, 1e-9);
  EXPECT_NEAR(areas[1] / areas[0], 1.0, 1e-6);
}

TEST(ModelHandle, BadFilesGiveAMessage)
{
  const test::TemporaryFolder folder;
  const std::string file = folder.Path() / "broken.json";
  std::ofstream(file) << "{";
  palpate_error error{};
  EXPECT_EQ(palpate_model_read(file.c_str(), &error), nullptr);
  EXPECT_NE(std::strstr(error.text, "broken.json"), nullptr) << error.text;
  EXPECT_EQ(palpate_model_read(file.c_str(), nullptr), nullptr);
  const auto handle = HandleOf(Bumpy());
  EXPECT_EQ(palpate_model_write(handle.get(), "model.unknown", &error), 0);
}

TEST(ModelHandle, RefusesWhatIsNoModel)
{
  const double center[3] = {0.0, 0.0, 0.0};
  double coefficient = std::numeric_limits<double>::quiet_NaN();
  palpate_error error{};
  EXPECT_EQ(palpate_model_create(0, &coefficient, center, &error), nullptr);
  coefficient = 1.0;
  EXPECT_EQ(palpate_model_create(-1, &coefficient, center, &error), nullptr);
  EXPECT_EQ(palpate_model_create(1001, &coefficient, center, &error), nullptr);
  double point[3];
  EXPECT_EQ(palpate_model_point(test::BallModel().get(), center, point, nullptr, &error), 0)
      << "no direction";
}

TEST(ModelHandle, NearestPointIsThatOfASphere)
{
  const test::TemporaryFolder folder;
  const std::string coef = folder.Path() / "ball.coef";
  const auto ball = test::BallModel();
  ASSERT_EQ(palpate_model_write(ball.get(), coef.c_str(), nullptr), 1);
  const Owned<palpate_model> surfaceModel(palpate_model_read(coef.c_str(), nullptr));
  for (palpate_model* model : {ball.get(), surfaceModel.get()})
  {
    const double query[3] = {0.0, 15.0, 0.0};
    Vector3 point;
    Vector3 normal;
    double distance = 0.0;
    ASSERT_EQ(palpate_model_nearest(model, query, point.data(), normal.data(), &distance, nullptr),
              1);
    EXPECT_NEAR(distance, -5.0, 1e-9);
    EXPECT_LT((point - Vector3(0.0, 20.0, 0.0)).norm(), 1e-6);
    EXPECT_LT((normal - Vector3::UnitY()).norm(), 1e-6);
    const double nowhere[3] = {0.0, std::numeric_limits<double>::infinity(), 0.0};
    EXPECT_EQ(
        palpate_model_nearest(model, nowhere, point.data(), normal.data(), &distance, nullptr), 0);
  }
}

// An ellipsoid, whose coordinates are harmonics of degree 1.
TEST(ModelHandle, BodyIsThatOfAnEllipsoid)
{
  const double unit = std::sqrt(4.0 * M_PI / 3.0);
  // x, y, z of each: constants, then the harmonics along y, z and x.
  const double coefficients[12] = {0.0, 0.0, 0.0, 9.0 * unit, 0.0,        15.0 * unit,
                                   0.0, 0.0, 0.0, 0.0,        6.0 * unit, 0.0};
  palpate_error error{};
  const Owned<palpate_model> model(palpate_model_create_surface(1, coefficients, &error));
  ASSERT_NE(model, nullptr) << error.text;
  palpate_body body;
  ASSERT_EQ(palpate_model_body(model.get(), &body, &error), 1) << error.text;
  EXPECT_NEAR(body.volume, 4.0 / 3.0 * M_PI * 15.0 * 9.0 * 6.0, 1e-8);
  const double semiAxes[3] = {15.0, 9.0, 6.0};
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(body.semi_axes[axis], semiAxes[axis], 1e-9);
    EXPECT_NEAR(body.centroid[axis], 0.0, 1e-9);
  }
  EXPECT_NEAR(std::abs(body.axes[1]), 1.0, 1e-9) << "the longest is y";
  double powers[2];
  ASSERT_EQ(palpate_model_spectrum(model.get(), powers, &error), 1) << error.text;
  EXPECT_NEAR(powers[0], 0.0, 1e-12);
  EXPECT_NEAR(powers[1], unit * unit * (225.0 + 81.0 + 36.0), 1e-9);
}

TEST(ModelHandle, MeshIsClosedAndHasTheVolume)
{
  const auto model = HandleOf(Bumpy());
  constexpr int Frequency = 12;
  std::vector<double> points(3 * palpate_mesh_point_count(Frequency));
  std::vector<double> normals(points.size());
  std::vector<int32_t> triangles(3 * palpate_mesh_triangle_count(Frequency));
  ASSERT_EQ(palpate_model_mesh(model.get(), Frequency, points.data(), normals.data(),
                               triangles.data(), nullptr),
            1);
  const auto at = [&](int32_t p)
  { return Vector3(points.data() + 3 * static_cast<std::size_t>(p)); };
  double sixfold = 0.0;
  std::set<std::pair<int32_t, int32_t>> edges;
  for (std::size_t t = 0; t < triangles.size(); t += 3)
  {
    const int32_t* c = triangles.data() + t;
    sixfold += at(c[0]).dot(at(c[1]).cross(at(c[2])));
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_TRUE(edges.emplace(c[i], c[(i + 1) % 3]).second) << "each once in each direction";
    }
  }
  for (const auto& [from, to] : edges)
  {
    EXPECT_EQ(edges.count({to, from}), 1U);
  }
  double volume = 0.0;
  double area = 0.0;
  ASSERT_EQ(palpate_model_measure(model.get(), &volume, &area, nullptr), 1);
  EXPECT_NEAR(sixfold / 6.0 / volume, 1.0, 0.02) << "chords lie inside";
  EXPECT_EQ(palpate_model_mesh(model.get(), 0, points.data(), nullptr, triangles.data(), nullptr),
            0);
}
} // namespace
} // namespace palpate::model_handle_test
