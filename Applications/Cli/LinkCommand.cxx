#include "LinkCommand.h"

#include "Console.h"
#include "FileType.h"
#include "FiniteNumber.h"
#include "IgtlConversion.h"
#include "InputError.h"
#include "Interruption.h"
#include "ModelFile.h"
#include "ModelSurface.h"
#include "Refusal.h"
#include "ScreenText.h"
#include "SurfaceFile.h"

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdlib>
#include <ostream>
#include <thread>

namespace palpate::cli
{
namespace
{
using LinkClock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds LookEvery(20);
} // namespace

std::string LinkCommand::Examples() const
{
  return "  palpate link 18944 --output received        wait for 3D Slicer on this machine\n"
         "  palpate link 18944 --output received --images 1   end after one image\n"
         "  palpate link scanner:18944 --output received      connect to a program that waits\n"
         "  palpate link 18944 gland/model.json zone/model.json   show models there, until Ctrl-C\n"
         "  palpate link 18944 gland/model.json --seconds 60";
}

void LinkCommand::DeclareOptions(CLI::App& app)
{
  app.add_option("PEER", this->Peer,
                 "PORT: wait for a program on this machine; *:PORT: on any; HOST:PORT: connect")
      ->required();
  app.add_option("MODEL", this->Models, "Models and surfaces to send to the program")
      ->check(FileType::Input("file"));
  // No FileType: 3D Slicer has OpenIGTLink itself, and should not offer this as a module.
  app.add_option("--output", this->OutputFolder,
                 "Folder for received images: image-1.nrrd, image-2.nrrd, ...; none is overwritten")
      ->type_name("DIR");
  app.add_option("--images", this->MostImages,
                 "End after this many images (default: end with an error at more than " +
                     std::to_string(IgtlQuota::UsualImages) + ")")
      ->check(CLI::Range(1, 100000));
  app.add_option("--gigabytes", this->Gigabytes,
                 "End with an error at more GB of voxels than this in all images")
      ->check(FiniteNumber::Between(1e-6, 1e6))
      ->capture_default_str();
  app.add_option("--seconds", this->Seconds, "End after this time, s (default: go on)")
      ->check(FiniteNumber::Between(0.0, 1e6));
  app.add_option("--frequency", this->Frequency,
                 "Subdivision F of the icosahedron for drawing a model: 20 F^2 triangles")
      ->check(CLI::Range(1, 200))
      ->capture_default_str();
}

void LinkCommand::OfferModels(IgtlLink& link) const
{
  std::vector<vtkSmartPointer<vtkPolyData>> surfaces;
  for (const std::string& path : this->Models)
  {
    surfaces.push_back(IsModelFile(path) ? DrawModel(ReadModel(path).Surface, this->Frequency)
                                         : ReadSurface(path));
  }
  link.Offer(SurfaceMessagesOf(surfaces));
}

void LinkCommand::Keep(const IgtlImage& image, Console& console)
{
  const Status status = this->Quota.Check(image.Voxels.size());
  if (!status.IsOk())
  {
    this->IsBeyondQuota = true;
    console.Error(status.Message() + ", so the link ends; allow more with --images and "
                                     "--gigabytes, or start it again");
    return;
  }
  try
  {
    const std::filesystem::path file = KeepImage(image, this->OutputFolder);
    this->Quota.Add(image.Voxels.size());
    console.Output() << Printable(file.string()) << ": " << image.Size[0] << " x " << image.Size[1]
                     << " x " << image.Size[2] << " voxels" << std::endl;
  }
  catch (const InputError& refusal)
  {
    this->Tell(refusal.what(), console); // what a peer sends does not end the connection
  }
}

// Of the same many times a second, once.
void LinkCommand::Tell(const std::string& note, Console& console)
{
  if (note != this->Told)
  {
    console.Note(note);
  }
  this->Told = note;
}

void LinkCommand::TakeImages(IgtlLink& link, Console& console)
{
  while (!this->HasAll())
  {
    const std::optional<IgtlImage> image = link.TakeImage();
    if (!image)
    {
      return;
    }
    if (this->OutputFolder.empty())
    {
      this->Tell("an image arrived; --output names a folder for it", console);
    }
    else
    {
      this->Keep(*image, console);
    }
  }
}

bool LinkCommand::HasAll() const
{
  return this->IsBeyondQuota || (this->MostImages > 0 && this->Quota.Images() >= this->MostImages);
}

int LinkCommand::Run(Console& console)
{
  const Interruption interruption;
  if (this->OutputFolder.empty() && this->Models.empty())
  {
    throw InputError(
        "There is nothing to do: give --output for received images, models to send, or "
        "both.");
  }
  IgtlPeer peer;
  RequireInput(ParseIgtlPeer(this->Peer, peer));
  this->Quota =
      IgtlQuota(this->MostImages > 0 ? this->MostImages : IgtlQuota::UsualImages, this->Gigabytes);
  IgtlLink link;
  this->OfferModels(link);
  if (!this->OutputFolder.empty())
  {
    std::filesystem::create_directories(this->OutputFolder);
  }
  RequireInput(link.Open(peer));
  console.Note(peer.Connects() ? "waiting on port " + std::to_string(link.Port())
                               : "connected to " + peer.Host);
  const LinkClock::time_point start = LinkClock::now();
  const std::chrono::duration<double> most(this->Seconds);
  while (!Interruption::WasAsked() && !link.HasEnded() && !this->HasAll() &&
         (this->Seconds <= 0.0 || LinkClock::now() - start < most))
  {
    std::this_thread::sleep_for(LookEvery);
    for (const std::string& problem : link.TakeProblems())
    {
      this->Tell(problem, console);
    }
    this->TakeImages(link, console);
  }
  return this->IsBeyondQuota ? EXIT_FAILURE : Interruption::ExitCode();
}
} // namespace palpate::cli
