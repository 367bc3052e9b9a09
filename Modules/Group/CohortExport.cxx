#include "CohortExport.h"

#include "InputError.h"
#include "ModelFile.h"
#include "OutputNames.h"
#include "Progress.h"
#include "ShapeAlignment.h"
#include "ShapeWorksFolder.h"
#include "SpharmPdmFolder.h"

#include <optional>
#include <set>
#include <string>

namespace palpate
{
namespace
{
OrganModel InPrincipalAxes(const OrganModel& model, const std::string& name)
{
  OrganModel aligned = model;
  if (const Status status = AlignShape(model, AlignmentAxes::Ellipsoid, aligned); !status.IsOk())
  {
    throw InputError(name + ": " + status.Message());
  }
  return aligned;
}

/// A name of files that no other case has.
std::string FreeName(const std::string& wanted, std::set<std::string>& taken)
{
  const std::string plain = PlainName(wanted);
  std::string name = plain;
  for (int k = 2; !taken.insert(name).second; ++k)
  {
    name = plain + "-" + std::to_string(k);
  }
  return name;
}
} // namespace

void ExportCohort(const CohortGroup& group, const std::filesystem::path& folder, ExportKind kind,
                  const std::filesystem::path& output, const ProgressFunction& progress)
{
  std::optional<ShapeWorksFolder> particles;
  if (kind == ExportKind::ShapeWorks)
  {
    particles.emplace(output);
  }
  std::set<std::string> taken;
  for (std::size_t i = 0; i < group.Rows.size(); ++i)
  {
    ReportProgress(progress, static_cast<double>(i) / static_cast<double>(group.Rows.size()),
                   "export");
    const std::string name = FreeName(group.Rows[i].Case, taken);
    const OrganModel patient = ReadModel((folder / group.Rows[i].Model).lexically_normal()).Surface;
    if (particles)
    {
      particles->Add(name, patient, group.Models[i]);
    }
    else
    {
      WriteSpharmPdmCase(
          {name, patient, InPrincipalAxes(patient, group.Rows[i].Case), group.Models[i]}, output);
    }
  }
  if (particles)
  {
    particles->Finish();
  }
}
} // namespace palpate
