#pragma once

#include "Command.h"
#include "ImageOptions.h"

#include <string>
#include <vector>

namespace palpate::cli
{
/// `palpate info FILE...`: the kind of each file, its geometry in patient LPS, its values, and for
/// segmentations a table of the labels. A file that cannot be read does not stop the others.
class InfoCommand : public Command
{
public:
  std::string Name() const override { return "info"; }
  std::string Summary() const override { return "Print the contents of images and segmentations"; }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  void Describe(const std::string& input, Console& console) const;
  void RecordLost(const std::string& input, const std::string& status, const std::string& message,
                  Console& console) const;

  std::vector<std::string> Inputs;
  ImageOptions Images;
  bool Json = false;
};
} // namespace palpate::cli
