#include "CheckFiles.h"

#include "CheckJson.h"
#include "CheckPage.h"
#include "OutputFolder.h"
#include "WholeFile.h"

namespace palpate
{
void WriteCheckFiles(const MaskChecks& checks, const std::filesystem::path& folder)
{
  WriteOutputSet(folder,
                 [&](const std::filesystem::path& stage)
                 {
                   WriteWholeFile(stage / "structures.csv", CheckTable(checks));
                   WriteWholeFile(stage / "check.json", CheckJson(checks, {}) + "\n");
                   WriteWholeFile(stage / "report.html", CheckPage(checks));
                 });
}
} // namespace palpate
