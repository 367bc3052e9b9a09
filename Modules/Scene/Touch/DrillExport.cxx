#include "DrillExport.h"

#include "FieldNodes.h"
#include "FieldOfImage.h"
#include "FilterRun.h"
#include "SceneIsoSurface.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <vector>

namespace palpate
{
namespace
{
const DrillSite& SiteOf(const DrillContext& context, int site)
{
  return context.Sites()[static_cast<std::size_t>(site)];
}

// A structure before drilling and now.
struct BeforeAndNow
{
  std::shared_ptr<const FieldSolid> Before;
  std::shared_ptr<const FieldSolid> Now;
};

// Clears the label of voxels in a row whose centres were in the solid before and no longer are.
void ClearRow(const BeforeAndNow& solids, const std::vector<Vector3>& centersWorld, double label,
              vtkDataArray& labels, vtkIdType first)
{
  std::vector<unsigned char> before(centersWorld.size());
  std::vector<unsigned char> now(centersWorld.size());
  solids.Before->AreInside(centersWorld.data(), centersWorld.size(), before.data());
  solids.Now->AreInside(centersWorld.data(), centersWorld.size(), now.data());
  for (std::size_t i = 0; i < now.size(); ++i)
  {
    const auto voxel = first + static_cast<vtkIdType>(i);
    if (before[i] != 0 && now[i] == 0 && labels.GetComponent(voxel, 0) == label)
    {
      labels.SetComponent(voxel, 0, 0.0);
    }
  }
}

void ClearLabels(const BeforeAndNow& solids, int label, vtkImageData* image,
                 const ProgressFunction& progress)
{
  const FieldGrid grid = GridOfImage(image);
  const std::array<int, 3>& size = grid.Size();
  std::vector<Vector3> centers(static_cast<std::size_t>(size[0]));
  vtkIdType first = 0;
  for (int k = 0; k < size[2]; ++k)
  {
    ReportProgress(progress, static_cast<double>(k) / size[2], "drilled labels");
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        centers[static_cast<std::size_t>(i)] = grid.PointWorld(Vector3(i, j, k));
      }
      ClearRow(solids, centers, label, *image->GetPointData()->GetScalars(), first);
      first += size[0];
    }
  }
}

void Require(const Status& status)
{
  if (!status.IsOk())
  {
    throw FilterError(status.Message());
  }
}

// A field's nodes as an image.
vtkSmartPointer<vtkImageData> ImageOf(const FieldGrid& grid, const std::vector<float>& nodes)
{
  vtkSmartPointer<vtkImageData> image = EmptyImageOf(grid);
  image->AllocateScalars(VTK_FLOAT, 1);
  std::copy(nodes.begin(), nodes.end(), static_cast<float*>(image->GetScalarPointer()));
  return image;
}
} // namespace

vtkSmartPointer<vtkImageData> DrilledImage(const DrillContext& context, int site,
                                           const ProgressFunction& progress)
{
  const DrillSource& source = SiteOf(context, site).Source;
  ReportProgress(progress, 0.0, "drilled image");
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->DeepCopy(source.Image);
  if (source.Label)
  {
    BeforeAndNow solids;
    const int material = context.Editor().Site(site).Material();
    const DrillReading reading = context.Editor().Newest();
    Require(FieldSolid::Make(source.Field, material, solids.Before));
    Require(FieldSolid::Make(reading.Fields[static_cast<std::size_t>(site)], material, solids.Now));
    ClearLabels(solids, *source.Label, image, progress);
    return image;
  }
  FieldSamples samples;
  Require(SamplesOfImage(source.Image, samples));
  context.Editor().WriteSamples(site, samples, image->GetScalarPointer());
  return image;
}

vtkSmartPointer<vtkPolyData> DrilledSurface(const DrillContext& context, int site,
                                            const ProgressFunction& progress)
{
  const DrilledField& drilled = context.Editor().Site(site);
  const auto now = context.Editor().Newest().Fields[static_cast<std::size_t>(site)];
  const std::vector<float> nodes = NodesOf(*now, drilled.Channel());
  return MakeIsoSurface(ImageOf(now->Grid(), nodes), drilled.Condition().Iso, progress);
}

vtkSmartPointer<vtkPolyData> RemovedSurface(const DrillContext& context, int site)
{
  DrillEditor::RemovedPart part = context.Editor().CopyRemoved(site);
  if (std::none_of(part.Distances.begin(), part.Distances.end(),
                   [](float distance) { return distance < 0.0F; }))
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  for (float& distance : part.Distances)
  {
    distance = -distance;
  }
  const auto goOn = [](double, const std::string&) { return true; };
  return MakeIsoSurface(ImageOf(part.Grid, part.Distances), 0.0, goOn);
}
} // namespace palpate
