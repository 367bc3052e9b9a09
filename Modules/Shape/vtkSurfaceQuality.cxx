#include "vtkSurfaceQuality.h"

#include "ClosestPointDistances.h"
#include "IsoSurface.h"
#include "MaskOverlap.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkSurfaceQuality);

namespace
{
struct WeightedDistance
{
  double Distance;
  double Weight;
};

// Appends the distances of one direction with weights that sum to one half.
void Append(const std::vector<double>& distances, const std::vector<double>& areas,
            std::vector<WeightedDistance>& all)
{
  const double total = std::accumulate(areas.begin(), areas.end(), 0.0);
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    all.push_back({distances[i], 0.5 * areas[i] / total});
  }
}

// Weighted percentile of sorted distances, `part` in [0, 1]; the weights sum to 1.
double Percentile(const std::vector<WeightedDistance>& sorted, double part)
{
  double weight = 0.0;
  for (const WeightedDistance& entry : sorted)
  {
    weight += entry.Weight;
    if (weight >= part)
    {
      return entry.Distance;
    }
  }
  return sorted.back().Distance;
}
} // namespace

void vtkSurfaceQuality::SetReferenceData(vtkPolyData* surface)
{
  this->SetInputDataObject(1, surface);
}

void vtkSurfaceQuality::SetMaskData(vtkImageData* mask)
{
  this->SetInputDataObject(2, mask);
}

int vtkSurfaceQuality::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 2 ? "vtkImageData" : "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 2 ? 1 : 0);
  return 1;
}

int vtkSurfaceQuality::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                   vtkInformationVector* outputs)
{
  vtkPolyData* tested = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* reference = vtkPolyData::GetData(inputs[1]);
  vtkImageData* mask = vtkImageData::GetData(inputs[2]);
  if (tested->GetNumberOfPolys() == 0 || reference->GetNumberOfPolys() == 0)
  {
    vtkErrorMacro("both surfaces need triangles to be compared");
    return 0;
  }
  const std::vector<double> there = palpate::ClosestPointDistances(tested->GetPoints(), reference);
  this->UpdateProgress(0.3);
  const std::vector<double> back = palpate::ClosestPointDistances(reference->GetPoints(), tested);
  this->UpdateProgress(0.8);
  if (this->AbortExecute)
  {
    return 1;
  }
  std::vector<WeightedDistance> all;
  Append(there, palpate::PointAreas(tested), all);
  Append(back, palpate::PointAreas(reference), all);
  std::sort(all.begin(), all.end(),
            [](const WeightedDistance& a, const WeightedDistance& b)
            { return a.Distance < b.Distance; });
  double sum = 0.0;
  double squares = 0.0;
  for (const WeightedDistance& entry : all)
  {
    sum += entry.Weight * entry.Distance;
    squares += entry.Weight * entry.Distance * entry.Distance;
  }
  this->MeanDistance = sum;
  this->RmsDistance = std::sqrt(squares);
  this->Percentile95Distance = Percentile(all, 0.95);
  this->MaximumDistance = all.back().Distance;

  const palpate::EnclosedMeasure measured = palpate::MeasureEnclosed(tested);
  const palpate::EnclosedMeasure expected = palpate::MeasureEnclosed(reference);
  this->Volume = measured.Volume;
  this->Area = measured.Area;
  this->VolumeDifference = measured.Volume - expected.Volume;
  this->AreaDifference = measured.Area - expected.Area;
  this->Dice = mask != nullptr ? palpate::DiceOfSurfaceAndMask(tested, mask, this->Label) : -1.0;

  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->ShallowCopy(tested);
  vtkNew<vtkDoubleArray> distances;
  distances->SetName("Distance");
  distances->SetNumberOfValues(tested->GetNumberOfPoints());
  std::copy(there.begin(), there.end(), distances->GetPointer(0));
  output->GetPointData()->AddArray(distances);
  this->UpdateProgress(1.0);
  return 1;
}

void vtkSurfaceQuality::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Label: " << this->Label << "\n";
  os << indent << "MeanDistance: " << this->MeanDistance << " mm\n";
  os << indent << "RmsDistance: " << this->RmsDistance << " mm\n";
  os << indent << "Percentile95Distance: " << this->Percentile95Distance << " mm\n";
  os << indent << "MaximumDistance: " << this->MaximumDistance << " mm\n";
  os << indent << "Volume: " << this->Volume << " mm^3\n";
  os << indent << "VolumeDifference: " << this->VolumeDifference << " mm^3\n";
  os << indent << "Area: " << this->Area << " mm^2\n";
  os << indent << "AreaDifference: " << this->AreaDifference << " mm^2\n";
  os << indent << "Dice: " << this->Dice << "\n";
}
