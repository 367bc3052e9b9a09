#pragma once

#include "ClosestPointSearch.h"
#include "ModelDocument.h"
#include "ParametricShape.h"

#include <memory>

/// A model of the C interface: the document that its file has, and the search that its first query
/// makes.
struct palpate_model
{
  palpate::ModelDocument Document;
  std::unique_ptr<const palpate::ClosestPointSearch> StarSearch;
  std::unique_ptr<const palpate::ClosestPointSearchOf<palpate::ParametricShape>> ParametricSearch;
};
