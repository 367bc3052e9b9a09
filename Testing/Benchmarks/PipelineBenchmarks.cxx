#include "PipelineBenchmarks.h"

#include "FitStructure.h"
#include "IcosahedronDirections.h"
#include "ImageWriter.h"
#include "ModelMeasures.h"
#include "NearestOnMesh.h"
#include "PhantomSampler.h"
#include "ProstateLikeModel.h"
#include "SegmentationFile.h"
#include "TemporaryFolder.h"
#include "TriangleMesh.h"

#include "vtkDiscreteFlyingEdges3D.h"
#include "vtkMassProperties.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"
#include "vtkWindowedSincPolyDataFilter.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace palpate::bench
{
namespace
{
// A prostate-like body of known shape on a clinical grid, in a file as users have it.
class PipelineCase
{
public:
  PipelineCase()
  {
    const RadialModel body = MakeProstateLikeModel(8, 1, Vector3::Zero());
    this->TrueVolume = VolumeOf(body);
    PhantomGrid grid;
    grid.Size = {384, 384, 23};
    grid.CenterOn(Vector3::Zero());
    this->File = this->Folder / "mask.nii.gz";
    WriteImage(this->File, MakePhantom(body, grid).Mask);
  }

  void Fit()
  {
    const Segmentation segmentation = ReadSegmentation(this->File);
    this->Result = FitStructure(segmentation, segmentation.Segments.front(), {});
  }

  void MeshTheStockWay()
  {
    const Segmentation segmentation = ReadSegmentation(this->File);
    vtkNew<vtkDiscreteFlyingEdges3D> contour;
    contour->SetInputData(segmentation.Layers.front());
    contour->SetValue(0, 1);
    vtkNew<vtkWindowedSincPolyDataFilter> smooth;
    smooth->SetInputConnection(contour->GetOutputPort());
    smooth->SetNumberOfIterations(20);
    smooth->SetPassBand(0.1);
    smooth->NonManifoldSmoothingOn();
    smooth->NormalizeCoordinatesOn();
    smooth->Update();
    vtkNew<vtkMassProperties> measure;
    measure->SetInputConnection(smooth->GetOutputPort());
    measure->Update();
    this->StockVolume = measure->GetVolume();
  }

  // Both should enclose the body; the stock surface shrinks by smoothing.
  std::string Disagreement() const
  {
    const double ours = this->Result.ModelMilliliters * 1000.0 / this->TrueVolume - 1.0;
    const double stock = this->StockVolume / this->TrueVolume - 1.0;
    if (std::abs(ours) <= 0.01 && std::abs(stock) <= 0.05 && this->Result.Dice >= 0.98)
    {
      return {};
    }
    std::ostringstream text;
    text << "of the true volume, ours misses " << 100.0 * ours << " % (" << this->Result.Message
         << "), the stock surface " << 100.0 * stock << " %";
    return text.str();
  }

private:
  test::TemporaryFolder Folder;
  std::filesystem::path File;
  double TrueVolume = 0.0;
  double StockVolume = 0.0;
  FitResult Result;
};

// The distances of a fine surface's 16,002 points from a coarse one of 8,000 triangles, both of one
// body: what the quality of a fit and a comparison take most.
class DistanceCase
{
public:
  DistanceCase() : Points(SurfaceOf(40).Points)
  {
    const IndexedMesh coarse = SurfaceOf(20);
    Check(NearestOnMesh::Make(coarse, this->Coarse));
    TriangleMesh mesh;
    mesh.PointsWorld = coarse.Points;
    mesh.Triangles = coarse.Triangles;
    this->Locator->SetDataSet(PolyDataOf(mesh));
    this->Locator->BuildLocator();
  }

  void Find() { this->Found = this->Coarse.DistancesOf(this->Points); }

  void FindByVtk()
  {
    this->FoundByVtk.resize(this->Points.size());
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      double nearest[3];
      vtkIdType cell = 0;
      int part = 0;
      double square = 0.0;
      this->Locator->FindClosestPoint(this->Points[i].data(), nearest, cell, part, square);
      this->FoundByVtk[i] = std::sqrt(square);
    }
  }

  std::string Disagreement() const
  {
    double largest = 0.0;
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      largest = std::max(largest, std::abs(this->Found[i] - this->FoundByVtk[i]));
    }
    return largest <= 1e-9 ? std::string()
                           : "distances differ by up to " + std::to_string(largest) + " mm";
  }

private:
  static IndexedMesh SurfaceOf(int frequency)
  {
    const RadialModel body = MakeProstateLikeModel(8, 1, Vector3::Zero());
    const IcosahedronDirections sphere(frequency);
    IndexedMesh mesh{sphere.Directions(), sphere.Triangles()};
    for (Vector3& point : mesh.Points)
    {
      point *= body.Radius(point);
    }
    return mesh;
  }
  static void Check(const Status& status)
  {
    if (!status.IsOk())
    {
      throw std::runtime_error(status.Message());
    }
  }

  std::vector<Vector3> Points;
  NearestOnMesh Coarse;
  vtkNew<vtkStaticCellLocator> Locator;
  std::vector<double> Found;
  std::vector<double> FoundByVtk;
};
} // namespace

std::vector<PairedBenchmark> PipelineBenchmarks()
{
  const auto pipeline = std::make_shared<PipelineCase>();
  const auto distances = std::make_shared<DistanceCase>();
  return {
      {"pipeline/fit/384x384x23", "read, vtkDiscreteFlyingEdges3D, vtkWindowedSincPolyDataFilter",
       [pipeline] { pipeline->Fit(); }, [pipeline] { pipeline->MeshTheStockWay(); },
       [pipeline] { return pipeline->Disagreement(); }},
      {"pipeline/distances/16002 points", "vtkStaticCellLocator (VTK as packaged, without AVX2)",
       [distances] { distances->Find(); }, [distances] { distances->FindByVtk(); },
       [distances] { return distances->Disagreement(); }}};
}
} // namespace palpate::bench
