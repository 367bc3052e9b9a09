#include "SoftwareRenderer.h"

#include "ArrayColors.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
constexpr int SamplesPerPixel = 2; // along each axis
constexpr double Margin = 1.12;    // image's half width over the bounding sphere's radius
constexpr SoftwareRenderer::Color DefaultColor{{214, 168, 140}};

float TwiceArea(float ax, float ay, float bx, float by, float cx, float cy)
{
  return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
}
// A white light above the viewer's left shoulder (Blinn-Phong).
class Lamp
{
public:
  Lamp(const Eigen::Vector3f& right, const Eigen::Vector3f& up, const Eigen::Vector3f& towards)
      : Direction((towards - 0.35F * right + 0.45F * up).normalized()),
        Halfway((this->Direction + towards).normalized())
  {
  }

  Eigen::Vector3f Light(const Eigen::Vector3f& color, const Eigen::Vector3f& normal) const
  {
    const float diffuse = std::max(0.0F, normal.dot(this->Direction));
    const float glance = std::max(0.0F, normal.dot(this->Halfway));
    const float power4 = glance * glance * glance * glance;
    const float power24 = power4 * power4 * power4 * power4 * power4 * power4;
    return (0.42F + 0.6F * diffuse) * color + Eigen::Vector3f::Constant(28.0F * power24);
  }

private:
  Eigen::Vector3f Direction;
  Eigen::Vector3f Halfway;
};
} // namespace

struct SoftwareRenderer::Samples
{
  explicit Samples(int across)
      : Across(across), Depth(Count(), -std::numeric_limits<float>::infinity()),
        Triangle(Count(), -1)
  {
  }
  std::size_t Count() const { return static_cast<std::size_t>(Across) * Across; }
  std::size_t At(int x, int y) const { return static_cast<std::size_t>(y) * Across + x; }

  int Across;
  std::vector<float> Depth;
  std::vector<int> Triangle; // the nearest one, or -1
};

SoftwareRenderer::SoftwareRenderer(vtkPolyData* mesh)
{
  double bounds[6];
  mesh->GetBounds(bounds);
  const Vector3 low(bounds[0], bounds[2], bounds[4]);
  const Vector3 high(bounds[1], bounds[3], bounds[5]);
  const Vector3 middle = 0.5 * (low + high);
  double squaredRadius = 0.0;
  this->Points.reserve(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    double point[3];
    mesh->GetPoint(p, point);
    const Vector3 offset = Vector3(point) - middle;
    squaredRadius = std::max(squaredRadius, offset.squaredNorm());
    this->Points.push_back(offset.cast<float>());
  }
  if (squaredRadius > 0.0)
  {
    this->HalfWidth = Margin * std::sqrt(squaredRadius);
  }
  this->AddTriangles(mesh);
  this->AddNormals(mesh);
  this->SetColor(DefaultColor);
}

void SoftwareRenderer::AddTriangles(vtkPolyData* mesh)
{
  const auto iterator = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(count, ids);
    for (vtkIdType corner = 2; corner < count; ++corner)
    {
      this->Triangles.push_back({static_cast<int>(ids[0]), static_cast<int>(ids[corner - 1]),
                                 static_cast<int>(ids[corner])});
    }
  }
}

void SoftwareRenderer::AddNormals(vtkPolyData* mesh)
{
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  if (!normals || normals->GetNumberOfComponents() != 3 ||
      normals->GetNumberOfTuples() != mesh->GetNumberOfPoints())
  {
    this->MakeNormals();
    return;
  }
  for (vtkIdType p = 0; p < normals->GetNumberOfTuples(); ++p)
  {
    double normal[3];
    normals->GetTuple(p, normal);
    this->Normals.push_back(Vector3(normal).cast<float>());
  }
}

void SoftwareRenderer::MakeNormals()
{
  this->Normals.assign(this->Points.size(), Eigen::Vector3f::Zero());
  for (const std::array<int, 3>& triangle : this->Triangles)
  {
    const Eigen::Vector3f& origin = this->Points[triangle[0]];
    const Eigen::Vector3f areaNormal =
        (this->Points[triangle[1]] - origin).cross(this->Points[triangle[2]] - origin);
    for (const int corner : triangle)
    {
      this->Normals[corner] += areaNormal;
    }
  }
  for (Eigen::Vector3f& normal : this->Normals)
  {
    normal.normalize();
  }
}

void SoftwareRenderer::SetColor(const Color& color)
{
  this->Colors.assign(this->Points.size(), color);
}

std::vector<SoftwareRenderer::Color> SoftwareRenderer::ColorsOf(vtkLookupTable* table,
                                                                const std::vector<double>& numbers)
{
  std::vector<Color> colors;
  for (const double number : numbers)
  {
    colors.push_back(ColorOf(table, number));
  }
  return colors;
}

void SoftwareRenderer::SetPointColors(std::vector<Color> colors)
{
  if (colors.size() == this->Points.size())
  {
    this->Colors = std::move(colors);
  }
}

std::vector<SoftwareRenderer::Projected> SoftwareRenderer::Project(const ViewFrame& frame,
                                                                   int samplesAcross) const
{
  const Eigen::Vector3f right = frame.RightWorld.cast<float>();
  const Eigen::Vector3f up = frame.UpWorld.cast<float>();
  const Eigen::Vector3f towards = frame.TowardsViewerWorld.cast<float>();
  const Lamp lamp(right, up, towards);
  const float half = 0.5F * static_cast<float>(samplesAcross);
  const float scale = half / static_cast<float>(this->HalfWidth);
  std::vector<Projected> projected;
  projected.reserve(this->Points.size());
  for (std::size_t p = 0; p < this->Points.size(); ++p)
  {
    const Eigen::Vector3f& point = this->Points[p];
    const Eigen::Vector3f color(this->Colors[p][0], this->Colors[p][1], this->Colors[p][2]);
    projected.push_back({half + scale * right.dot(point), half - scale * up.dot(point),
                         towards.dot(point), lamp.Light(color, this->Normals[p]),
                         lamp.Light(color, -this->Normals[p])});
  }
  return projected;
}

void SoftwareRenderer::Rasterise(const std::vector<Projected>& points, Samples& samples) const
{
  const float largest = static_cast<float>(samples.Across) - 1.0F;
  const auto first = [](float low)
  { return static_cast<int>(std::max(0.0F, std::ceil(low - 0.5F))); };
  const auto last = [largest](float high)
  { return static_cast<int>(std::min(largest, std::floor(high - 0.5F))); };
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    const Projected& a = points[this->Triangles[t][0]];
    const Projected& b = points[this->Triangles[t][1]];
    const Projected& c = points[this->Triangles[t][2]];
    const float area = TwiceArea(a.X, a.Y, b.X, b.Y, c.X, c.Y);
    if (!(std::abs(area) > 0.0F)) // seen edge-on, or not a number
    {
      continue;
    }
    // Increments of the barycentric weights of a and b from sample to sample of a row.
    const float stepA = (b.Y - c.Y) / area;
    const float stepB = (c.Y - a.Y) / area;
    const int startX = first(std::min({a.X, b.X, c.X}));
    const int endX = last(std::max({a.X, b.X, c.X}));
    const int endY = last(std::max({a.Y, b.Y, c.Y}));
    for (int y = first(std::min({a.Y, b.Y, c.Y})); y <= endY; ++y)
    {
      const float px = static_cast<float>(startX) + 0.5F;
      const float py = static_cast<float>(y) + 0.5F;
      float wa = TwiceArea(b.X, b.Y, c.X, c.Y, px, py) / area;
      float wb = TwiceArea(c.X, c.Y, a.X, a.Y, px, py) / area;
      std::size_t sample = samples.At(startX, y);
      for (int x = startX; x <= endX; ++x, ++sample, wa += stepA, wb += stepB)
      {
        const float wc = 1.0F - wa - wb;
        const float depth = wa * a.Depth + wb * b.Depth + wc * c.Depth;
        // A little wider than the triangle, so that rounding leaves no gap along shared edges.
        if (std::min(std::min(wa, wb), wc) >= -1e-4F && depth > samples.Depth[sample])
        {
          samples.Depth[sample] = depth;
          samples.Triangle[sample] = static_cast<int>(t);
        }
      }
    }
  }
}

Eigen::Vector3f SoftwareRenderer::ColorAt(int triangle, float x, float y,
                                          const std::vector<Projected>& points) const
{
  const std::array<int, 3>& corners = this->Triangles[static_cast<std::size_t>(triangle)];
  const Projected& a = points[corners[0]];
  const Projected& b = points[corners[1]];
  const Projected& c = points[corners[2]];
  const float area = TwiceArea(a.X, a.Y, b.X, b.Y, c.X, c.Y);
  const float wa = TwiceArea(b.X, b.Y, c.X, c.Y, x, y) / area;
  const float wb = TwiceArea(c.X, c.Y, a.X, a.Y, x, y) / area;
  const float wc = 1.0F - wa - wb;
  // Y points down in the image, so a triangle that faces the viewer has a negative area.
  return area < 0.0F ? Eigen::Vector3f(wa * a.Front + wb * b.Front + wc * c.Front)
                     : Eigen::Vector3f(wa * a.Back + wb * b.Back + wc * c.Back);
}

void SoftwareRenderer::Resolve(int column, int row, const Samples& samples,
                               const std::vector<Projected>& points, std::uint8_t* pixel) const
{
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  int covered = 0;
  for (int part = 0; part < SamplesPerPixel * SamplesPerPixel; ++part)
  {
    const int x = SamplesPerPixel * column + part % SamplesPerPixel;
    const int y = SamplesPerPixel * row + part / SamplesPerPixel;
    const int triangle = samples.Triangle[samples.At(x, y)];
    if (triangle >= 0)
    {
      sum += this->ColorAt(triangle, static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F,
                           points);
      ++covered;
    }
  }
  for (int channel = 0; covered > 0 && channel < 3; ++channel)
  {
    const float mean = sum[channel] / static_cast<float>(covered);
    pixel[channel] = static_cast<std::uint8_t>(std::clamp(mean + 0.5F, 0.0F, 255.0F));
  }
  pixel[3] = static_cast<std::uint8_t>(255 * covered / (SamplesPerPixel * SamplesPerPixel));
}

RasterImage SoftwareRenderer::Render(ViewSide side, int size) const
{
  Samples samples(SamplesPerPixel * size);
  const std::vector<Projected> points = this->Project(FrameOf(side), samples.Across);
  this->Rasterise(points, samples);
  RasterImage raster(size, size);
  for (int row = 0; row < size; ++row)
  {
    for (int column = 0; column < size; ++column)
    {
      this->Resolve(column, row, samples, points, raster.Pixel(column, row));
    }
  }
  return raster;
}
} // namespace palpate
