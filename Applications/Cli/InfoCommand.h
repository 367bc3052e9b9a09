#pragma once

#include "CaseTally.h"
#include "Command.h"
#include "ImageContent.h"
#include "ImageOptions.h"

#include <functional>
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
  void Describe(const std::string& input, ImageContent content, Console& console) const;
  bool DescribeAsOne(const std::string& input, Console& console);
  void Attempt(const std::string& input, const std::function<void()>& describe, Console& console);
  void RecordLost(const std::string& input, const std::string& status, const std::string& message,
                  Console& console) const;

  std::vector<std::string> Inputs;
  ImageOptions Images;
  bool Json = false;
  CaseTally Tally;
};
} // namespace palpate::cli
