#pragma once

#include "Command.h"
#include "IgtlLink.h"
#include "IgtlQuota.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::cli
{
/// `palpate link`: images and label maps from another program by OpenIGTLink, models to it.
class LinkCommand : public Command
{
public:
  std::string Name() const override { return "link"; }
  std::string Summary() const override
  {
    return "Receive images and send models by OpenIGTLink, as 3D Slicer does";
  }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  void OfferModels(IgtlLink& link) const;
  void TakeImages(IgtlLink& link, Console& console);
  void Keep(const IgtlImage& image, Console& console);
  void Tell(const std::string& note, Console& console);
  bool HasAll() const;

  std::string Peer;
  std::vector<std::string> Models;
  std::filesystem::path OutputFolder;
  int Frequency = 20;
  int MostImages = 0; ///< 0: until the quota is used up
  double Gigabytes = IgtlQuota::UsualGigabytes;
  double Seconds = 0.0;
  IgtlQuota Quota;
  bool IsBeyondQuota = false;
  std::string Told; ///< the last note
};
} // namespace palpate::cli
