#include "SliceInSpace.h"

#include "ImageAxes.h"
#include "SlicePainter.h"
#include "vtkImageDisplay.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double OutlineWidth = 2.0;
constexpr double LongestSide = 512.0; // pixels

// The polygon in which a plane cuts the box of an image; empty if it misses it.
std::vector<Vector3> CutBox(const ImageAxes& axes, const Vector3& through, const Vector3& normal)
{
  const std::vector<SurfaceCurve> curves =
      CutSurface(MakeBox(axes.CornersWorld()), through, normal);
  return curves.empty() ? std::vector<Vector3>{} : curves.front().Points;
}
} // namespace

SliceInSpace::SliceInSpace(SliceOrientation orientation) : Orientation(orientation)
{
  this->Patch.SetInterpolate(true);
  this->Outline.SetStyle(ColorOf(orientation), 1.0, OutlineWidth);
  this->Add(this->Patch.Actor());
  this->Add(this->Outline.Actor());
}

PixelGrid SliceInSpace::GridOf(const std::vector<Vector3>& corners, const ViewFrame& frame,
                               double pixelMillimeters) const
{
  Eigen::AlignedBox2d box;
  for (const Vector3& corner : corners)
  {
    box.extend(Eigen::Vector2d(corner.dot(frame.RightWorld), corner.dot(frame.UpWorld)));
  }
  const double pixel = std::max(pixelMillimeters, box.sizes().maxCoeff() / LongestSide);
  const Vector3 normal = frame.TowardsViewerWorld;
  PixelGrid grid;
  grid.Width = std::max(1, static_cast<int>(std::ceil(box.sizes().x() / pixel)));
  grid.Height = std::max(1, static_cast<int>(std::ceil(box.sizes().y() / pixel)));
  grid.ColumnWorld = box.sizes().x() / grid.Width * frame.RightWorld;
  grid.RowWorld = box.sizes().y() / grid.Height * frame.UpWorld;
  grid.FirstWorld = box.min().x() * frame.RightWorld + box.min().y() * frame.UpWorld +
                    corners.front().dot(normal) * normal + 0.5 * (grid.ColumnWorld + grid.RowWorld);
  return grid;
}

void SliceInSpace::Update(vtkImageDisplay* display, bool isAlongImage, const Vector3& throughWorld)
{
  vtkImageData* image = display == nullptr ? nullptr : display->GetImage();
  if (image != nullptr)
  {
    const ViewFrame frame = SliceGeometry(this->Orientation, isAlongImage, image).Frame;
    const Vector3& normal = frame.TowardsViewerWorld;
    const double height = throughWorld.dot(normal);
    const std::uint64_t time = display->GetMTime();
    if (time != this->PaintedTime || height != this->PaintedHeight || normal != this->PaintedNormal)
    {
      const ImageAxes axes(image);
      const std::vector<Vector3> corners = CutBox(axes, throughWorld, normal);
      this->IsEmpty = corners.size() < 3;
      if (!this->IsEmpty)
      {
        const double pixel = *std::min_element(axes.Spacing.begin(), axes.Spacing.end());
        const PixelGrid grid = this->GridOf(corners, frame, pixel);
        PaintSlice(display->GetContent(), grid, this->Patch.RasterImage());
        this->Patch.Place(grid, corners);
        this->Outline.SetCurves({{corners, true}}, Vector3::Zero());
      }
      this->PaintedTime = time;
      this->PaintedHeight = height;
      this->PaintedNormal = normal;
    }
  }
  this->SetVisible(image != nullptr && !this->IsEmpty);
}
} // namespace palpate
