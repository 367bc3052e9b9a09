#include "ComparisonMap.h"

#include "AnatomicalView.h"
#include "ArrayColors.h"
#include "SixViews.h"
#include "TriangleMesh.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
constexpr int TileSize = 400; // pixels of the picture
constexpr int TilesAcross = 3;

vtkSmartPointer<vtkPolyData> Mapped(const ComparedBody& body, const DistanceMap& map, bool isSigned)
{
  TriangleMesh mesh;
  mesh.PointsWorld = body.Surface().Points;
  mesh.Triangles = body.Surface().Triangles;
  mesh.Values.push_back({isSigned ? "SignedDistance" : "Distance", map.Values});
  return PolyDataOf(mesh);
}

SoftwareRenderer Coloured(vtkPolyData* surface, vtkLookupTable* colors)
{
  vtkDataArray* distances = surface->GetPointData()->GetArray(0);
  std::vector<double> values;
  for (vtkIdType p = 0; p < distances->GetNumberOfTuples(); ++p)
  {
    values.push_back(distances->GetComponent(p, 0));
  }
  SoftwareRenderer renderer(surface);
  renderer.SetPointColors(SoftwareRenderer::ColorsOf(colors, values));
  return renderer;
}

// A transparent tile over white.
void Paste(const RasterImage& tile, int column, int row, RasterImage& picture)
{
  for (int y = 0; y < tile.Height; ++y)
  {
    for (int x = 0; x < tile.Width; ++x)
    {
      const std::uint8_t* from = tile.Pixel(x, y);
      std::uint8_t* to = picture.Pixel(column + x, row + y);
      for (int channel = 0; channel < 3; ++channel)
      {
        to[channel] =
            static_cast<std::uint8_t>((from[channel] * from[3] + 255 * (255 - from[3])) / 255);
      }
      to[3] = 255;
    }
  }
}
} // namespace

// Full colour at the 95th percentile: a few extremes must not take the rest's contrast.
ComparisonMap::ComparisonMap(const PairComparison& pair)
    : OneSurface(Mapped(*pair.OneBody, pair.Numbers.OneToOther, pair.OtherBody->IsClosed())),
      OtherSurface(Mapped(*pair.OtherBody, pair.Numbers.OtherToOne, pair.OneBody->IsClosed())),
      Colors(MakeArrayColors(-std::max(1e-3, pair.Numbers.Hausdorff95()),
                             std::max(1e-3, pair.Numbers.Hausdorff95())))
{
}

void ComparisonMap::AddViews(ReportPage& page, vtkPolyData* surface) const
{
  const bool isSigned = surface->GetPointData()->GetArray("SignedDistance") != nullptr;
  AddSixViews(page, Coloured(surface, this->Colors));
  AddColorBar(page, this->Colors, isSigned ? "inside the other one" : "", "mm",
              isSigned ? "outside" : "apart");
}

RasterImage ComparisonMap::Picture() const
{
  const SoftwareRenderer renderer = Coloured(this->OneSurface, this->Colors);
  const auto count = static_cast<int>(AllViewSides.size());
  RasterImage picture(TilesAcross * TileSize, (count + TilesAcross - 1) / TilesAcross * TileSize);
  for (int view = 0; view < count; ++view)
  {
    Paste(renderer.Render(AllViewSides[static_cast<std::size_t>(view)], TileSize),
          view % TilesAcross * TileSize, view / TilesAcross * TileSize, picture);
  }
  return picture;
}
} // namespace palpate
