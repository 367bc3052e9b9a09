#pragma once

#include "CenteredSurface.h"
#include "ClosestPointSearch.h"
#include "ModelDocument.h"

#include <memory>
#include <mutex>
#include <utility>

/// A model of the C interface: the document that its file has, and the search that its first query
/// makes.
struct palpate_model
{
  explicit palpate_model(palpate::ModelDocument document) : Document(std::move(document)) {}

  palpate::ModelDocument Document;
  std::string Changes; ///< by the fit to a mask, see ChangeText
  std::once_flag HasSearch;
  std::unique_ptr<const palpate::ClosestPointSearch> RadialSearch;
  std::unique_ptr<const palpate::ClosestPointSearchOf<palpate::CenteredSurface>> SurfaceSearch;
};
