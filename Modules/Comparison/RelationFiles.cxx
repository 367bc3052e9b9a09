#include "RelationFiles.h"

#include "OutputFolder.h"
#include "OutputNames.h"
#include "RelationJson.h"
#include "RelationPage.h"
#include "RelationTable.h"
#include "SurfaceFile.h"
#include "WholeFile.h"

#include <set>
#include <string>

namespace palpate
{
void WriteRelationFiles(const OrganRelations& relations, const std::filesystem::path& folder)
{
  WriteOutputSet(folder,
                 [&](const std::filesystem::path& stage)
                 {
                   WriteWholeFile(stage / "organs.csv", OrganTable(relations));
                   WriteWholeFile(stage / "pairs.csv", OrganPairTable(relations));
                   WriteWholeFile(stage / "relations.json", RelationJson(relations, {}) + "\n");
                   WriteWholeFile(stage / "report.html", RelationPage(relations));
                 });
  const std::filesystem::path surfaces = folder / "surfaces";
  MakeOutputFolder(surfaces);
  std::set<std::string> taken;
  for (const RelatedOrgan& organ : relations.Organs)
  {
    if (organ.IsMeasured())
    {
      std::string name = PlainName(organ.Name);
      for (int n = 2; !taken.insert(FoldedName(name)).second; ++n)
      {
        name = PlainName(organ.Name) + "_" + std::to_string(n);
      }
      WriteSurface(surfaces / (name + ".vtp"), MappedOrgan(organ));
    }
  }
}
} // namespace palpate
