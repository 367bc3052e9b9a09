#include "FieldRenderer.h"

#include "BeamClearance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
constexpr int BeamSide = 4; // pixels

std::uint8_t Byte(double part) noexcept
{
  return static_cast<std::uint8_t>(std::lrint(255.0 * std::clamp(part, 0.0, 1.0)));
}
} // namespace

FieldRenderer::FieldRenderer(std::shared_ptr<const ScalarField> field, FieldView view)
    : Caster(std::move(field)), Scene(std::move(view)),
      VectorToScene(Scene.ToScene.topLeftCorner<3, 3>()),
      NormalToScene(VectorToScene.inverse().transpose())
{
  const int count = this->Caster.Field().MaterialCount();
  this->Scene.Looks.resize(static_cast<std::size_t>(count));
  for (int material = 0; material < count; ++material)
  {
    const double opacity = this->Scene.Looks[static_cast<std::size_t>(material)].Opacity;
    if (opacity > 0.0)
    {
      this->Shown |= OnlyMaterial(material);
      this->Opaque = this->Opaque && opacity >= 1.0;
    }
  }
  const std::vector<HalfSpace> sides = this->Scene.Crop.Sides(this->Caster.Field().Grid());
  this->Scene.Kept.insert(this->Scene.Kept.end(), sides.begin(), sides.end());
  if (!sides.empty())
  {
    this->Scene.Crop = CropRegions();
  }
}

FieldRenderer::Ray FieldRenderer::RayAt(double x, double y) const noexcept
{
  const FieldRay ray = this->Scene.Rays.At(x, y);
  return {ray, ClippedInterval(ray, this->Scene.Kept, {})};
}

FieldHit FieldRenderer::NextHit(const FieldRay& ray, RayInterval interval) const noexcept
{
  const FieldGrid& grid = this->Caster.Field().Grid();
  for (;;)
  {
    FieldHit hit = this->Caster.CastWorld(ray, interval.From, interval.To, this->Shown);
    const bool isHit = hit.Kind == HitKind::Surface || hit.Kind == HitKind::Border;
    if (!isHit || this->Scene.Crop.ShowsAll() ||
        this->Scene.Crop.Shows(grid.PointIndex(hit.Position)))
    {
      return hit;
    }
    interval.From = std::nextafter(hit.T, std::numeric_limits<double>::infinity());
  }
}

FieldHit FieldRenderer::FirstHitAt(double x, double y) const noexcept
{
  const Ray ray = this->RayAt(x, y);
  return this->NextHit(ray.World, ray.Interval);
}

Vector3 FieldRenderer::ColorOf(const FieldHit& hit, const Vector3& toEyeScene) const noexcept
{
  const MaterialLook& look = this->Scene.Looks[static_cast<std::size_t>(hit.Material)];
  const Vector3 normal = -(this->NormalToScene * hit.Gradient);
  const double length = normal.norm();
  const Vector3 point = (this->Scene.ToScene * hit.Position.homogeneous()).hnormalized();
  return ShadedColor(look.Color, this->Scene.Finish, this->Scene.Lights, point,
                     length > 0.0 ? Vector3(normal / length) : toEyeScene, toEyeScene);
}

// Up to which t no ray of these pixels meets anything.
double FieldRenderer::ClearBeam(int column0, int column1, int row0, int row1,
                                double from) const noexcept
{
  const FieldGrid& grid = this->Caster.Field().Grid();
  const int columns[2] = {column0, column1 - 1};
  const int rows[2] = {row0, row1 - 1};
  FieldRay corners[4];
  for (int corner = 0; corner < 4; ++corner)
  {
    const FieldRay world = this->Scene.Rays.OfPixel(columns[corner % 2], rows[corner / 2]);
    corners[corner] = {grid.PointIndex(world.Origin), grid.VectorIndex(world.Direction)};
  }
  return ClearUntil(this->Caster.Field(), BeamOf(corners), from, 1.0);
}

void FieldRenderer::DrawPixel(int column, int row, double from,
                              FieldPicture& picture) const noexcept
{
  const std::size_t pixel = picture.Pixel(column, row);
  Ray ray = this->RayAt(column + 0.5, row + 0.5);
  ray.Interval.From = std::max(ray.Interval.From, from);
  if (!this->Scene.SceneDepths.empty())
  {
    const double end = this->Scene.Rays.ParameterAtDepth(ray.World, this->Scene.SceneDepths[pixel]);
    ray.Interval.To = std::min(ray.Interval.To, end);
  }
  FieldHit hit;
  if (ray.Interval.From < ray.Interval.To)
  {
    hit = this->NextHit(ray.World, ray.Interval);
  }
  if (!picture.Hits.empty())
  {
    picture.Hits[pixel] = hit;
  }
  const bool isAny = hit.Material >= 0;
  picture.Depths[pixel] = isAny ? static_cast<float>(this->Scene.Rays.Depth(hit.Position)) : 1.0F;
  Vector3 color = Vector3::Zero();
  double open = 1.0; // how much of what lies behind is seen
  const Vector3 toEye =
      isAny ? (-(this->VectorToScene * ray.World.Direction)).normalized().eval() : Vector3::Zero();
  // Below half a step of the picture nothing behind is seen.
  constexpr double LeastOpen = 0.5 / 255.0;
  while (hit.Material >= 0)
  {
    const double opacity =
        std::min(1.0, this->Scene.Looks[static_cast<std::size_t>(hit.Material)].Opacity);
    color += open * opacity * this->ColorOf(hit, toEye);
    open *= 1.0 - opacity;
    if (open < LeastOpen)
    {
      open = 0.0;
      break;
    }
    ray.Interval.From = std::nextafter(hit.T, std::numeric_limits<double>::infinity());
    hit = this->NextHit(ray.World, ray.Interval);
  }
  std::uint8_t* bytes = &picture.Colors[4 * pixel];
  bytes[0] = Byte(color[0]);
  bytes[1] = Byte(color[1]);
  bytes[2] = Byte(color[2]);
  bytes[3] = Byte(1.0 - open);
}

void FieldRenderer::DrawBeam(int column0, int column1, int row0, int row1, double from,
                             FieldPicture& picture) const noexcept
{
  for (int row = row0; row < row1; ++row)
  {
    for (int column = column0; column < column1; ++column)
    {
      this->DrawPixel(column, row, from, picture);
    }
  }
}

void FieldRenderer::DrawTile(int column0, int column1, int row0, int row1,
                             FieldPicture& picture) const noexcept
{
  // What is empty before all of them, the rays skip together.
  const double clear = this->ClearBeam(column0, column1, row0, row1, 0.0);
  if (clear >= 1.0)
  {
    return picture.Clear(column0, column1, row0, row1);
  }
  for (int row = row0; row < row1; row += BeamSide)
  {
    for (int column = column0; column < column1; column += BeamSide)
    {
      const int columnEnd = std::min(column1, column + BeamSide);
      const int rowEnd = std::min(row1, row + BeamSide);
      const double from = this->ClearBeam(column, columnEnd, row, rowEnd, clear);
      from < 1.0 ? this->DrawBeam(column, columnEnd, row, rowEnd, from, picture)
                 : picture.Clear(column, columnEnd, row, rowEnd);
    }
  }
}
} // namespace palpate
