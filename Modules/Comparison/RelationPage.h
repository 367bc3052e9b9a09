#pragma once

#include "OrganRelations.h"
#include "PalpateComparisonModule.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace palpate
{
/// `report.html`: all organs from six sides, what describes each, the nearest pairs.
PALPATECOMPARISON_EXPORT std::string RelationPage(const OrganRelations& relations);
/// What the command prints: a line for each organ and near pair.
PALPATECOMPARISON_EXPORT std::string RelationText(const OrganRelations& relations);
/// An organ's surface (mm, patient LPS) with the point arrays "Thickness", "Distance" (mm, NaN
/// beyond the reach) and "Neighbour" (place in the list of organs, -1 for none).
PALPATECOMPARISON_EXPORT vtkSmartPointer<vtkPolyData> MappedOrgan(const RelatedOrgan& organ);
} // namespace palpate
