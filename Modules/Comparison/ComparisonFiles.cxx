#include "ComparisonFiles.h"

#include "ComparisonMap.h"
#include "ComparisonOverview.h"
#include "ComparisonPage.h"
#include "ComparisonTable.h"
#include "OutputFolder.h"
#include "OutputNames.h"
#include "SurfaceFile.h"
#include "WholeFile.h"

namespace palpate
{
void WriteComparisonFiles(const PairComparison& pair, const std::filesystem::path& folder)
{
  const ComparisonMap map(pair);
  WriteOutputSet(folder,
                 [&](const std::filesystem::path& stage)
                 {
                   WriteSurface(stage / "first.vtp", map.One());
                   WriteSurface(stage / "reference.vtp", map.Other());
                   WriteWholeFile(stage / "map.png", EncodePng(map.Picture()));
                   WriteWholeFile(stage / "report.html", ComparisonPage(pair, map));
                 });
}

void WriteComparisonOverview(const std::vector<PairComparison>& pairs,
                             const std::vector<std::string>& unpaired,
                             const std::vector<double>& tolerances,
                             const std::filesystem::path& folder)
{
  WriteOutputSet(folder,
                 [&](const std::filesystem::path& stage)
                 {
                   WriteComparisonTable(pairs, tolerances, stage / "comparison.csv");
                   WriteWholeFile(stage / "report.html", ComparisonOverview(pairs, unpaired));
                 });
}

std::filesystem::path PairFolder(const PairComparison& pair)
{
  const Segment& structure = pair.One.Structure;
  return structure.Label == 0
             ? std::filesystem::path(PlainName(pair.Case))
             : PlainName(pair.Case) / std::filesystem::path(StructureFolderName(structure));
}
} // namespace palpate
