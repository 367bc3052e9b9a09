#pragma once

#include "BodyGeodesics.h"
#include "Command.h"
#include "ImageOptions.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::cli
{
/// `palpate measure FILE --from --to`: distances along a surface.
class MeasureCommand : public Command
{
public:
  std::string Name() const override { return "measure"; }
  std::string Summary() const override
  {
    return "Measure distances along an organ's surface: between points, and as a map";
  }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  std::string JsonOf(const BodyGeodesics& body,
                     const std::vector<BodyGeodesics::Length>& lengths) const;

  std::filesystem::path Input;
  std::string Label;
  std::string From;
  std::vector<std::string> To;
  ImageOptions Images;
  std::filesystem::path Path;
  std::filesystem::path Map;
  bool Json = false;
};
} // namespace palpate::cli
