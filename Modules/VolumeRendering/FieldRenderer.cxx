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
constexpr int BeamPixels = BeamSide * BeamSide;

// The pixels of a beam in square blocks, since rays that are cast together should be neighbours.
struct Place
{
  int Column, Row;
};
constexpr Place InSquares[BeamPixels] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {2, 0}, {3, 0},
                                         {2, 1}, {3, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3},
                                         {2, 2}, {3, 2}, {2, 3}, {3, 3}};

std::uint8_t Byte(double part) noexcept
{
  return static_cast<std::uint8_t>(std::lrint(255.0 * std::clamp(part, 0.0, 1.0)));
}
} // namespace

FieldRenderer::FieldRenderer(std::shared_ptr<const ScalarField> field, FieldView view)
    : Caster(std::move(field)), Scene(std::move(view)),
      VectorToScene(Scene.ToScene.topLeftCorner<3, 3>()),
      NormalToScene(VectorToScene.inverse().transpose()), Shading(Scene.Finish, Scene.Lights),
      NeedsPoints(Shading.NeedsPoints() || Scene.Contact.IsSeen())
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
}

RayInterval FieldRenderer::ShownInterval(const FieldRay& ray) const noexcept
{
  RayInterval interval;
  for (const Eigen::Hyperplane<double, 3>& plane : this->Scene.Kept)
  {
    const Vector3 normal = plane.normal();
    const double height = normal.dot(ray.Origin) + plane.offset();
    const double rise = normal.dot(ray.Direction);
    if (rise > 0.0)
    {
      interval.From = std::max(interval.From, -height / rise);
    }
    else if (rise < 0.0)
    {
      interval.To = std::min(interval.To, -height / rise);
    }
    else if (!(height >= 0.0))
    {
      return {1.0, -1.0};
    }
  }
  return interval;
}

// The interval of a pixel's ray to search, starting at `from`.
RayInterval FieldRenderer::IntervalOf(const FieldRay& ray, std::size_t pixel,
                                      double from) const noexcept
{
  RayInterval interval = this->ShownInterval(ray);
  interval.From = std::max(interval.From, from);
  if (!this->Scene.SceneDepths.empty())
  {
    const double end = this->Scene.Rays.ParameterAtDepth(ray, this->Scene.SceneDepths[pixel]);
    interval.To = std::min(interval.To, end);
  }
  return interval;
}

FieldHit FieldRenderer::FirstHitAt(double x, double y) const noexcept
{
  const FieldRay ray = this->Scene.Rays.At(x, y);
  const RayInterval interval = this->ShownInterval(ray);
  return this->Caster.CastWorld(ray, interval.From, interval.To, this->Shown);
}

Vector3 FieldRenderer::ColorOf(const FieldHit& hit, const Vector3& toEyeScene) const noexcept
{
  const MaterialLook& look = this->Scene.Looks[static_cast<std::size_t>(hit.Material)];
  const Vector3 normal = -(this->NormalToScene * hit.Gradient);
  const double length = normal.norm();
  const Vector3 facing = length > 0.0 ? Vector3(1.0 / length * normal) : toEyeScene;
  if (!this->NeedsPoints)
  {
    return this->Shading.ColorAt(Vector3::Zero(), look.Color, facing, toEyeScene);
  }
  const Vector3 point = (this->Scene.ToScene * hit.Position.homogeneous()).hnormalized();
  const ContactMark& contact = this->Scene.Contact;
  const double share = contact.IsSeen() ? contact.ShareAt(point) : 0.0;
  const Vector3 color = (1.0 - share) * look.Color + share * contact.Color;
  return this->Shading.ColorAt(point, color, facing, toEyeScene);
}

// The parameter t up to which no ray of these pixels hits anything.
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

// Blends from the first visible hit; surfaces behind it are cast ray by ray.
void FieldRenderer::DrawPixel(const FieldRay& ray, RayInterval interval, FieldHit& hit,
                              std::size_t pixel, FieldImage& image) const noexcept
{
  if (!image.Hits.empty())
  {
    image.Hits[pixel] = hit;
  }
  if (hit.Material < 0)
  {
    return image.Clear(pixel);
  }
  image.Depths[pixel] = static_cast<float>(this->Scene.Rays.Depth(hit.Position));
  Vector3 color = Vector3::Zero();
  double open = 1.0; // transmittance so far
  const Vector3 fromEye = this->VectorToScene * ray.Direction;
  const Vector3 toEye = -1.0 / fromEye.norm() * fromEye;
  // Below half a colour step nothing behind is visible.
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
    interval.From = std::nextafter(hit.T, std::numeric_limits<double>::infinity());
    hit = this->Caster.CastWorld(ray, interval.From, interval.To, this->Shown);
  }
  std::uint8_t* bytes = &image.Colors[4 * pixel];
  bytes[0] = Byte(color[0]);
  bytes[1] = Byte(color[1]);
  bytes[2] = Byte(color[2]);
  bytes[3] = Byte(1.0 - open);
}

struct FieldRenderer::Beam
{
  FieldRay Rays[BeamPixels];
  RayInterval Intervals[BeamPixels];
  std::size_t Pixels[BeamPixels];
  FieldHit Hits[BeamPixels];
};

void FieldRenderer::DrawBeam(int column0, int column1, int row0, int row1, double from, Beam& beam,
                             FieldImage& image) const noexcept
{
  auto& [rays, intervals, pixels, hits] = beam;
  std::size_t count = 0;
  for (int n = 0; n < BeamPixels; ++n)
  {
    const int column = column0 + InSquares[n].Column;
    const int row = row0 + InSquares[n].Row;
    if (column < column1 && row < row1)
    {
      pixels[count] = image.Pixel(column, row);
      rays[count] = this->Scene.Rays.OfPixel(column, row);
      intervals[count] = this->IntervalOf(rays[count], pixels[count], from);
      ++count;
    }
  }
  this->Caster.CastAllWorld(rays, intervals, count, hits, this->Shown);
  for (std::size_t n = 0; n < count; ++n)
  {
    if (!(intervals[n].From < intervals[n].To))
    {
      hits[n] = FieldHit();
    }
    this->DrawPixel(rays[n], intervals[n], hits[n], pixels[n], image);
  }
}

void FieldRenderer::DrawTile(int column0, int column1, int row0, int row1,
                             FieldImage& image) const noexcept
{
  // All rays skip the common empty space together.
  const double clear = this->ClearBeam(column0, column1, row0, row1, 0.0);
  if (clear >= 1.0)
  {
    return image.Clear(column0, column1, row0, row1);
  }
  Beam beam;
  for (int row = row0; row < row1; row += BeamSide)
  {
    for (int column = column0; column < column1; column += BeamSide)
    {
      const int columnEnd = std::min(column1, column + BeamSide);
      const int rowEnd = std::min(row1, row + BeamSide);
      const double from = this->ClearBeam(column, columnEnd, row, rowEnd, clear);
      from < 1.0 ? this->DrawBeam(column, columnEnd, row, rowEnd, from, beam, image)
                 : image.Clear(column, columnEnd, row, rowEnd);
    }
  }
}
} // namespace palpate
