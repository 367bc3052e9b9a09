#include "ModelTable.h"

#include "SphericalHarmonicBasis.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkTable.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace palpate
{
void ToTable(const RadialModel& model, vtkTable* table)
{
  vtkNew<vtkIntArray> degrees;
  degrees->SetName("Degree");
  vtkNew<vtkIntArray> orders;
  orders->SetName("Order");
  vtkNew<vtkDoubleArray> coefficients;
  coefficients->SetName("Coefficient");
  for (int l = 0; l <= model.Degree(); ++l)
  {
    for (int m = -l; m <= l; ++m)
    {
      degrees->InsertNextValue(l);
      orders->InsertNextValue(m);
      coefficients->InsertNextValue(model.Coefficients()[SphericalHarmonicBasis::Index(l, m)]);
    }
  }
  vtkNew<vtkDoubleArray> center;
  center->SetName("Center");
  center->SetNumberOfComponents(3);
  center->InsertNextTuple(model.CenterWorld().data());
  table->Initialize();
  table->AddColumn(degrees);
  table->AddColumn(orders);
  table->AddColumn(coefficients);
  table->GetFieldData()->AddArray(center);
}

bool FromTable(vtkTable* table, RadialModel& model)
{
  auto* degrees = vtkDataArray::SafeDownCast(table->GetColumnByName("Degree"));
  auto* orders = vtkDataArray::SafeDownCast(table->GetColumnByName("Order"));
  auto* coefficients = vtkDataArray::SafeDownCast(table->GetColumnByName("Coefficient"));
  vtkDataArray* center = table->GetFieldData()->GetArray("Center");
  if (degrees == nullptr || orders == nullptr || coefficients == nullptr || center == nullptr ||
      center->GetNumberOfComponents() != 3 || center->GetNumberOfTuples() != 1 ||
      table->GetNumberOfRows() == 0)
  {
    return false;
  }
  // A table may omit coefficients up to its highest degree, but not hold more.
  const auto degree = static_cast<int>(degrees->GetRange()[1]);
  if (degree < 0 || degree > 10000)
  {
    return false;
  }
  std::vector<double> values(SphericalHarmonicBasis::CoefficientCount(degree), 0.0);
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const auto l = static_cast<int>(degrees->GetTuple1(row));
    const auto m = static_cast<int>(orders->GetTuple1(row));
    if (l < 0 || std::abs(m) > l)
    {
      return false;
    }
    values[SphericalHarmonicBasis::Index(l, m)] = coefficients->GetTuple1(row);
  }
  model = RadialModel(degree, std::move(values), Vector3(center->GetTuple(0)));
  return true;
}
} // namespace palpate
