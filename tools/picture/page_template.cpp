/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The page that a picture is put into, as a part of the program.
 */

#include "page_template.h"

#include <pcl_cid/exceptions.h>

#ifdef PCL_CID_PAGE_TEMPLATE
asm(".pushsection .rodata\n"
    "pcl_cid_page_template:\n"
    ".incbin \"" PCL_CID_PAGE_TEMPLATE "\"\n"
    "pcl_cid_page_template_end:\n"
    ".byte 0\n"
    ".popsection\n");

extern "C" {
extern const char pcl_cid_page_template[];
extern const char pcl_cid_page_template_end[];
}
#endif

namespace pcl_cid::tools {
namespace {

constexpr std::string_view gap = "<!-- data -->";

} // namespace

std::string_view
pageTemplate()
{
#ifdef PCL_CID_PAGE_TEMPLATE
  return {pcl_cid_page_template,
          static_cast<std::size_t>(pcl_cid_page_template_end - pcl_cid_page_template)};
#else
  return {};
#endif
}

void
requirePageTemplate(std::string_view page)
{
  if (page.empty())
    throw CIDException("--html: this program was built without the page that a picture "
                       "is put into; install npm (Debian: nodejs, npm) and build it "
                       "again with PCL_CID_BUILD_STUDIO=ON");
}

std::string
filledPage(std::string_view page, const std::string& content)
{
  const std::size_t at = page.find(gap);
  std::string filled(page.substr(0, at));
  filled.reserve(page.size() + content.size());
  filled += content;
  filled += page.substr(at + gap.size());
  return filled;
}

} // namespace pcl_cid::tools
