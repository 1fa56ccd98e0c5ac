/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The interpreter's lock, let go of and taken again.
 */

#include "gil.h"

#include <cxxabi.h>
#include <unistd.h>

namespace pcl_cid::python {
namespace {

[[noreturn]] void
waitForTheEnd()
{
  for (;;)
    pause();
}

} // namespace

GilReleased::GilReleased() : state_(PyEval_SaveThread())
{
}

GilReleased::~GilReleased()
{
  try {
    PyEval_RestoreThread(state_);
  }
  catch (abi::__forced_unwind&) {
    waitForTheEnd();
  }
}

GilAcquired::GilAcquired()
{
  try {
    acquired_.emplace();
  }
  catch (abi::__forced_unwind&) {
    waitForTheEnd();
  }
}

} // namespace pcl_cid::python
