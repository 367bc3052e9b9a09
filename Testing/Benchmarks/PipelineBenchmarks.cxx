#include "PipelineBenchmarks.h"

#include "FitStructure.h"
#include "ImageWriter.h"
#include "PhantomSampler.h"
#include "ProstateLikeModel.h"
#include "SegmentationFile.h"
#include "SphericalHarmonicMeasures.h"
#include "TemporaryFolder.h"

#include "vtkDiscreteFlyingEdges3D.h"
#include "vtkMassProperties.h"
#include "vtkNew.h"
#include "vtkWindowedSincPolyDataFilter.h"

#include <cmath>
#include <memory>
#include <sstream>

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
    const SphericalHarmonicModel body = MakeProstateLikeModel(8, 1, Vector3::Zero());
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
} // namespace

std::vector<PairedBenchmark> PipelineBenchmarks()
{
  const auto pipeline = std::make_shared<PipelineCase>();
  return {{"pipeline/fit/384x384x23",
           "read, vtkDiscreteFlyingEdges3D, vtkWindowedSincPolyDataFilter",
           [pipeline] { pipeline->Fit(); }, [pipeline] { pipeline->MeshTheStockWay(); },
           [pipeline] { return pipeline->Disagreement(); }}};
}
} // namespace palpate::bench
