#pragma once

#include "vtkNew.h"
#include "vtkTestErrorObserver.h"
#include "vtkXMLParser.h"

#include <string>

namespace palpate::test
{
/// What expat finds wrong with a piece of markup; empty where it is well-formed XML (our HTML is
/// written so that it is that, too).
inline std::string MarkupError(const std::string& markup)
{
  vtkNew<vtkXMLParser> parser;
  vtkNew<vtkTest::ErrorObserver> observer;
  parser->AddObserver(vtkCommand::ErrorEvent, observer);
  const int isGood = parser->Parse(markup.c_str(), static_cast<unsigned int>(markup.size()));
  return isGood != 0 ? std::string() : "not well-formed: " + observer->GetErrorMessage();
}
} // namespace palpate::test
