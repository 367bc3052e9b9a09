#include "SceneMemory.h"

#include "BrickFile.h"
#include "CoarseHarmonicModel.h"
#include "DecimalText.h"
#include "FieldContactModel.h"
#include "FieldProxyTracker.h"
#include "FilterRun.h"
#include "InputError.h"
#include "OnDemandContactModel.h"
#include "OnDemandHarmonicModel.h"
#include "TouchStandIns.h"

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
// "coarse degree 4, raised by 2.1 mm, until the tool is within 4.0 mm of its box".
std::string OnDemandText(const OnDemandHarmonics& harmonics, double nearFrom)
{
  constexpr double Milli = 1e3;
  return ", on demand: coarse degree " + std::to_string(OnDemandHarmonics::CoarseDegree) +
         ", raised by " + FixedText(harmonics.RaisedBy(), 1) + " mm, until the tool is within " +
         FixedText(nearFrom, 1) + " mm of its box; then " + Megabytes(harmonics.BytesAtHand()) +
         " more, made in " + FixedText(Milli * harmonics.MakingSeconds(), 1) + " ms";
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

TouchContact SceneMemory::Take(const SphericalHarmonicModel& model, const HarmonicForm& form,
                               const std::filesystem::path& file)
{
  const auto whole = [&](const std::string& why)
  {
    TouchContact contact = MakeHarmonicContact(model, form.Mode, form.Precision, file);
    contact.Represented += ", whole, since " + why;
    return contact;
  };
  if (model.Degree() <= OnDemandHarmonics::CoarseDegree)
  {
    return whole("no lower degree takes less");
  }
  OnDemandHarmonics::Settings settings;
  settings.Mode = form.Mode;
  settings.Precision = form.Precision;
  settings.StandIns = StandInDegrees(model.Degree());
  settings.Tool = this->Tool;
  std::shared_ptr<OnDemandHarmonics> made;
  const auto shared = std::make_shared<const SphericalHarmonicModel>(model);
  const Status status = OnDemandHarmonics::Make(shared, settings, made);
  if (!status.IsOk())
  {
    return whole("no coarse body can stand in: " + status.Message());
  }
  this->Harmonics.push_back(made);
  this->Kept += made->KeptBytes();
  this->AtHand += made->BytesAtHand();
  this->Largest = std::max(this->Largest, made->BytesAtHand());
  TouchContact contact;
  contact.Looks.Model = shared;
  contact.Mode = form.Mode;
  contact.Precision = form.Precision;
  contact.Represented = HarmonicText(model, form.Mode, form.Precision);
  contact.Model = std::make_shared<const OnDemandHarmonicModel>(made, 0);
  contact.Coarser = StandInsOnDemand(made);
  contact.Beneath = std::make_shared<const CoarseHarmonicModel>(made);
  contact.Harmonics = std::move(made);
  return contact;
}

// As much of what is left as they are of all, but no less than the largest.
std::size_t SceneMemory::RoomOfHarmonics() const
{
  if (*this->Budget < this->Kept + this->Largest)
  {
    const std::string largest =
        this->Harmonics.empty() ? "" : " and the largest model takes " + Megabytes(this->Largest);
    throw InputError("what the scene is touched by does not fit into " + Megabytes(*this->Budget) +
                     ", since what is kept of all its bricks and degrees takes " +
                     Megabytes(this->Kept) + largest + "; give more as \"memory_mb\", or none");
  }
  const auto left = static_cast<double>(*this->Budget - this->Kept);
  const auto all = static_cast<double>(this->AtHand + this->Pools);
  const double part = all > 0.0 ? std::min(1.0, left / all) : 0.0;
  return std::max(this->Largest,
                  static_cast<std::size_t>(part * static_cast<double>(this->AtHand)));
}

void SceneMemory::GivePools(std::size_t bytes) const
{
  const double part = std::min(1.0, static_cast<double>(bytes) / static_cast<double>(this->Pools));
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
  if (this->Fields.empty() && this->Harmonics.empty())
  {
    return;
  }
  const std::size_t room = this->RoomOfHarmonics();
  if (!this->Fields.empty())
  {
    this->GivePools(*this->Budget - this->Kept - room);
  }
  if (!this->Harmonics.empty())
  {
    OnDemandDegrees::Settings settings;
    settings.ToolRadius = this->Tool.BoundingRadius();
    settings.Room = room;
    made.Degrees = std::make_shared<OnDemandDegrees>(this->Harmonics, settings);
    made.Account.HarmonicsRoom = room;
  }
  this->SayWhatIsInMemory(made);
}

// What is touched is in the account in the same order.
void SceneMemory::SayWhatIsInMemory(TouchStructures& made) const
{
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
    if (structure.Harmonics != nullptr)
    {
      account->Contact.Is += OnDemandText(*structure.Harmonics, made.Degrees->NearFrom());
      structure.Represented = account->Contact.Is;
    }
    ++account;
  }
}
} // namespace palpate
