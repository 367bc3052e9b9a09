#include "SceneMemory.h"

#include "BrickFile.h"
#include "FieldContactModel.h"
#include "FieldProxyTracker.h"
#include "FilterRun.h"
#include "HtmlText.h"
#include "InputError.h"
#include "OnDemandContactModel.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr double Mega = 1e6;

std::string Megabytes(std::size_t bytes)
{
  return FixedText(static_cast<double>(bytes) / Mega, 1) + " MB";
}
} // namespace

SceneMemory::SceneMemory(const std::optional<double>& megabytes, const ToolShape& tool) : Tool(tool)
{
  if (megabytes)
  {
    this->Budget = static_cast<std::size_t>(*megabytes * Mega);
  }
}

TouchContact SceneMemory::Take(const std::shared_ptr<const ScalarField>& field,
                               const std::filesystem::path& file)
{
  TouchContact contact = MakeFieldContact(field, 0, file);
  const double voxel = field->Grid().Spacing().minCoeff();
  OnDemandField::Settings settings;
  settings.AskedReach =
      FieldProxyTracker::AskedReachOf(FieldContactModel::ShellFor(this->Tool, voxel), voxel);
  std::unique_ptr<BrickSource> source;
  const Status written = BrickFile::Make(*field, std::filesystem::temp_directory_path(), source);
  if (!written.IsOk())
  {
    throw FilterError(written.Message());
  }
  std::shared_ptr<OnDemandField> made;
  const Status status = OnDemandField::Make(*field, 0, std::make_shared<const FieldSurvey>(*field),
                                            std::move(source), settings, made);
  if (!status.IsOk())
  {
    contact.Represented += ", whole, since no coarse one can stand in: " + status.Message();
    return contact;
  }
  this->Fields.push_back(made);
  this->Kept += made->KeptBytes();
  this->Pools += made->LargestPool();
  contact.Looks.Field = nullptr;
  contact.Model = std::make_shared<const OnDemandContactModel>(made);
  contact.OnDemand = std::move(made);
  return contact;
}

void SceneMemory::GivePools() const
{
  if (*this->Budget < this->Kept)
  {
    throw InputError("the scene's fields do not fit into " + Megabytes(*this->Budget) +
                     ", since what is kept of all their bricks takes " + Megabytes(this->Kept) +
                     "; give more as \"memory_mb\", or none");
  }
  const double part = std::min(1.0, static_cast<double>(*this->Budget - this->Kept) /
                                        static_cast<double>(this->Pools));
  for (const std::shared_ptr<OnDemandField>& field : this->Fields)
  {
    const double all = static_cast<double>(field->LargestPool());
    const Status status = field->GivePool(static_cast<std::size_t>(part * all));
    if (!status.IsOk())
    {
      throw InputError("the scene's fields do not fit into " + Megabytes(*this->Budget) + ": " +
                       status.Message() + " Give more as \"memory_mb\", or none");
    }
  }
}

void SceneMemory::Share(TouchStructures& made) const
{
  made.Account.MemoryBudget = this->Budget.value_or(0);
  if (!this->Fields.empty())
  {
    this->GivePools();
  }
  // What is touched is in the account in the same order.
  auto account = made.Account.Structures.begin();
  for (TouchableStructure& structure : made.Touched)
  {
    account =
        std::find_if(account, made.Account.Structures.end(),
                     [](const SceneStructureAccount& one) { return !one.Contact.Is.empty(); });
    if (structure.OnDemand != nullptr)
    {
      account->Contact.Bytes += structure.OnDemand->Bytes() - structure.OnDemand->KeptBytes();
      account->Contact.Is +=
          ", on demand: " + Megabytes(structure.OnDemand->Bytes()) + " in memory";
      structure.Represented = account->Contact.Is;
    }
    ++account;
  }
}
} // namespace palpate
