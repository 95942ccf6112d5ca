# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Errors to plant in the module for mutation_test.py.

A mutant is a name and a list of replacements (file in Modules/NBuffer, exact old text, new text);
the old text must be there exactly once.
"""

PROJECTION = "vtkNBufferProjection.cxx"
BOX_ERROR = "vtkNBufferBoxError.h"
VIEW = "vtkNBufferView.cxx"
CANDIDATE = "vtkNBufferCandidate.cxx"
CANDIDATE_TREE = "vtkNBufferCandidateTree.cxx"
CASTER = "vtkShadowCaster.cxx"
SURFACE = "vtkNBufferSurface.cxx"
HIERARCHY = "vtkNBufferHierarchy.cxx"
FRAME_KEY = "vtkShadowFrameKey.cxx"
DIVIDED = "vtkNBufferDividedProp.cxx"
HOOK = "vtkNBufferDrawHook.cxx"
UNIT_CULLING = "vtkNBufferUnitCulling.cxx"
UNITS = "vtkNBufferUnits.cxx"
OWN_DRAW = "vtkNBufferOwnDraw.cxx"
INSTANCES = "vtkNBufferInstanceStream.cxx"
MASK_MAKER = "vtkShadowMaskMaker.cxx"
PLAN = "vtkShadowPlan.cxx"
DRAW_LIST = "vtkShadowDrawList.cxx"
LITMAP_SET = "vtkShadowLitmapSet.cxx"
REACH = "vtkShadowUmbra.cxx"
VOLUME = "vtkShadowVolume.cxx"
BLOCKS = "vtkNBufferBlocks.cxx"

NO_VERTEX_SLACK = [(BOX_ERROR, "VertexErrors = 6.0 *", "VertexErrors = 0.0 *"),
                   (BOX_ERROR, "OriginErrors = 4.0 *", "OriginErrors = 0.0 *")]
NO_DEPTH_SLACK = [
    ("vtkNBufferBoxError.cxx",
     "format.Slack = 2.0 * quantum + DepthErrors * vtkNBufferBoxError::UnitRoundoff;",
     "format.Slack = 0.0 * quantum;"),
    ("vtkNBufferBoxError.cxx", "(OvershootInPixels + this->PlaneRounding) / LowestHeight;",
     "0.0 / LowestHeight;")]

NEAR_PLANE_TEST = (
    "if (!(w > this->Error.w && clip.z + clip.w > this->Error.z + this->Error.w))")

MUTANTS = {
    # Tolerances.
    "no slack at all": [*NO_VERTEX_SLACK, *NO_DEPTH_SLACK,
                        (BOX_ERROR, "LargestSnap = 1.0 / 16;", "LargestSnap = 0.0;")],
    "no slack for rounded vertices": NO_VERTEX_SLACK,
    "vertices believed to be near the buffer's zero": [
        ("vtkNBufferVertexCoordinates.cxx", "return IsShifted(mapper, low, high)",
         "return (IsShifted(mapper, low, high) || true)")],
    "no margin for wide lines and points": [
        (CANDIDATE, "this->Box.Margin = vtkNBufferSurface::GetMargin(actor);",
         "this->Box.Margin = 0.0;")],

    # What is read.
    "rows that are not read keep the depth of an earlier frame": [
        ("vtkNBufferBackend.cxx", "endRead = std::min(this->EndRead, size);", "endRead = 0;")],

    # The hierarchy over the props.
    "hierarchy of boxes that lack their upper parts": [
        (HIERARCHY, "this->High = glm::max(this->High, high);",
         "this->High = glm::max(this->High, low);")],
    "held-back props below visible nodes of the hierarchy count as hidden": [
        (CANDIDATE_TREE, "isInside ? test.GetClearance(screen) : 0.0", "1.0")],

    # Units of large props.
    "boxes of units 1 % too small": [
        (UNIT_CULLING, "vtkNBufferBox box = vtkNBufferBox::FromBounds(values);",
         "vtkNBufferBox box = vtkNBufferBox::FromBounds(values); box.HalfSize *= 0.99;")],
    "groups in space treated as runs": [
        (UNITS, "if (!this->AreSpatial())", "if (true)")],
    "lists of the device in another order than the mesh": [
        ("vtkNBufferListCS.glsl", "return before[i] - mine;", "return all - before[i];")],
    "lists of the device without the last primitive of a work group's part": [
        ("vtkNBufferListCS.glsl", "sums[gl_WorkGroupID.x] = all;",
         "sums[gl_WorkGroupID.x] = all - min(all, 1u);")],
    "fresh units over those that come later in the mesh": [
        ("vtkNBufferTieOrder.cxx", "a.Round > b.Round;", "a.Round < b.Round;")],
    "cell values of a shortened list": [
        (OWN_DRAW, "SetUniformi(Offset, static_cast<int>(range.Begin));", "SetUniformi(Offset, 0);")],
    "a mapper keeps having no indices": [
        (OWN_DRAW,
         "this->Stream->IBO->IndexCount = std::exchange(this->IndexCount, 0);",
         "this->IndexCount = 0;")],
    "size of gaussian points left out": [
        (DIVIDED, "vtkNBufferSurface::GetMarginOfLines(this->Actor->GetProperty())", "0.0")],
    "indices of a mesh that was replaced": [
        (HOOK, "buffer.Marked.clear(); // The same units of another mesh have other indices.", "")],
    "units of data that have changed": [
        (DIVIDED, "data->GetMTime() == source.DataTime;", "true;"),
        (HOOK, "source.Corners == 0 || !(source == this->Read) || (source.IsNumbered",
         "source.Corners == 0 || (source.IsNumbered")],
    "the list of the first source drawn for all sources": [
        (INSTANCES, "  Batch* batch = this->Find(GetKey(mapper, stream));",
         "  Batch* batch = this->Batches.front().get();")],
    "instances of a source counted from the first source": [
        (INSTANCES, "{ batch.First, batch.First + batch.Size }", "{ 0, batch.Size }")],
    "translucent units not tested in this frame": [
        (DIVIDED, "  this->Culling.ClearDrawn();\n  this->TestUnits(projection, depth);\n",
         "  (void)projection;\n  (void)depth;\n")],
    "translucent glyphs tested as a whole by the bounds that VTK estimates": [
        ("vtkNBufferCandidate.h", "(this->IsTranslucent() && !this->HasInstances)",
         "this->IsTranslucent()")],
    "units that are hidden stay hidden": [
        (UNIT_CULLING, "this->FreshUnits[unit] = !this->DrawnUnits[unit];",
         "this->FreshUnits[unit] = !this->DrawnUnits[unit] && this->Turn % 2 != 0;")],
    "units that are left to another test are not tested again": [
        (DIVIDED, "this->Settled = this->IsDrawn && !this->Postponed;",
         "this->Settled = this->IsDrawn;"),
        (DIVIDED, "this->Settled = !this->Postponed;", "this->Settled = true;")],

    # Triangles.
    "only one triangle of a mesh looked at": [
        ("vtkNBufferPixelTest.cxx", "for (std::size_t n = 0; n < std::min(size, count); ++n)",
         "for (std::size_t n = 0; n < std::min<std::size_t>(size, 1); ++n)")],
    "outlines of triangles one pixel short": [
        ("vtkNBufferPixelTest.cxx", "glm::dvec2(side.y, -side.x), corners, slack);",
         "glm::dvec2(side.y, -side.x), corners, slack - 1.0);")],

    # Rectangles and lookups.
    "rectangle one pixel short at the right and top": [
        (PROJECTION, "end[i] = static_cast<int>(std::ceil(to));",
         "end[i] = std::max(static_cast<int>(std::ceil(to)) - 1, begin[i] + 1);"),
        (PROJECTION, "std::floor(to - 0.5));", "std::floor(to - 1.5));")],
    "rectangle one pixel short at the left and bottom": [
        (PROJECTION, "end[i] = static_cast<int>(std::ceil(to));",
         "end[i] = static_cast<int>(std::ceil(to));\n"
         "    begin[i] = std::min(begin[i] + 1, end[i] - 1);"),
        (PROJECTION, "std::ceil(from - 0.5));", "std::ceil(from + 0.5));")],
    "base rectangle one texel short": [
        ("vtkNBufferMath.cxx", "texels.X1 = GetBaseSize(pixels.X1, factor);",
         "texels.X1 = std::max(pixels.X1 / factor, texels.X0 + 1);")],
    "squares of a level side by side with a gap": [
        ("vtkNBufferLevelBuilder.h", "const int step = 1 << (i - 1);", "const int step = 1 << i;")],
    "one of the four lookups left out": [
        ("vtkNBufferMath.h", "for (int i = 1; i < cover.Count; ++i)",
         "for (int i = 1; i < cover.Count - 1; ++i)")],
    "the last level not built": [
        ("vtkNBufferLevelBuilder.h", "for (int i = first; i < end; ++i)",
         "for (int i = first; i < end - 1; ++i)")],
    "pixel test one column short": [
        ("vtkNBufferPixelTest.cxx", "column < std::min(x + Side, pixels.X1)",
         "column < std::min(x + Side, pixels.X1 - 1)")],
    "one round too many (>= turned to >)": [
        (VIEW, "this->Statistics.Rounds >= this->Settings.MaximumNumberOfRounds",
         "this->Statistics.Rounds > this->Settings.MaximumNumberOfRounds")],

    # Depth.
    "samples in the middles of pixels only": [
        ("vtkNBufferDepthSource.cxx", "source.Places.Places.emplace_back(x, y);",
         "source.Places.Places.emplace_back(0.5, 0.5);")],
    "one sample of a multisampled pixel": [
        ("Shaders/vtkNBufferBaseFS.glsl", "for (int i = 0; i < NBUFFER_SAMPLES; ++i)",
         "for (int i = 0; i < 1; ++i)")],
    "viewport's origin ignored on the host": [
        ("vtkNBufferBackend.cxx", "job.Source.Read(job.Window, viewport[0], viewport[1] +",
         "job.Source.Read(job.Window, 0, 0 +")],
    "viewport's origin ignored on the device": [
        ("vtkNBufferBackend.cxx",
         "texture->Build(job.Window, job.Source, viewport[0], viewport[1], viewport[2], viewport[3],",
         "texture->Build(job.Window, job.Source, 0, 0, viewport[2], viewport[3],")],

    "reversed depth read as VTK's": [
        ("vtkNBufferDepthSource.cxx", "? vtkNBufferStoredDepth::Reversed",
         "? vtkNBufferStoredDepth::Ordinary")],
    "the nearest of several reversed depths hides": [
        ("vtkNBufferDepthConvention.h", "? vtkNBufferExtremum::Minimum",
         "? vtkNBufferExtremum::Maximum")],

    # The near plane.
    "crossing the near plane or the eye counts as inside": [
        (PROJECTION, NEAR_PLANE_TEST, "if (std::isnan(w))")],
    "the part of a box behind the eye is forgotten": [
        (PROJECTION, "result.Clipped = !before;", "result.Clipped = !before;\n  before = true;")],

    # From frame to frame.
    "stale bounds": [
        ("vtkNBufferCandidate.h",
         ": this->Watch.MayHaveChanged(observedAreUnchanged);",
         ": this->Verdict == vtkNBufferVerdict::NoBounds && this->Watch.MayHaveChanged(true);")],
    "camera's motion not noticed": [
        ("vtkNBufferCamera.h", "return this->WorldToClip == other.WorldToClip &&", "return")],
    "verdicts of the last frame reused although props changed": [
        (VIEW, "listChanged || this->Statistics.Refreshed > 0 || moved, frozen)",
         "moved, frozen)")],
    "order of equal depths forgotten": [
        ("vtkNBufferLateDraws.cxx", "if (this->Drawn.empty())", "if (!this->Drawn.empty())")],
    "held-back props drawn after those that blend": [
        ("vtkNBufferListMaker.cxx", "props + std::min(firstBlended, kept)", "props + kept")],
    "props after one that blends held back": [
        ("vtkNBufferPartition.cxx", "if (i >= firstBlended && ", "if (i == firstBlended && ")],
    "slices of images count as opaque": [
        ("vtkNBufferDrawOrder.cxx", "GetInput() || property->GetOpacity() < 1.0 ||",
         "GetInput() ||")],
    "translucent back faces count as opaque": [
        ("vtkNBufferDrawOrder.cxx", "(back && back->GetOpacity() < 1.0) ||", "")],
    "selected cells count as opaque": [
        ("vtkNBufferDrawOrder.cxx", "isForced || isSelected ||", "isForced ||")],
    "props that blend drawn again for their depth": [
        ("vtkNBufferLateDraws.cxx",
         "std::min(this->Props.GetSize(), partition.GetFirstBlended())",
         "this->Props.GetSize()")],
    "equal depths of overlapping rectangles forgotten": [
        ("vtkNBufferTieOrder.cxx",
         "return projection.GetContact(a.Box, a.Screen, b.Box, b.Screen);",
         "return a.Screen.Pixels.X0 < b.Screen.Pixels.X0\n"
         "    ? projection.GetContact(a.Box, a.Screen, b.Box, b.Screen)\n"
         "    : vtkNBufferContact();")],
    "what is drawn again is drawn outside of its regions, too": [
        ("vtkNBufferScissor.h", "scissor.Set(region);", "")],
    "regions in which props touch one column short": [
        (PROJECTION, "contact.Screen.Pixels = cut(screen.Pixels, sharedScreen.Pixels);",
         "contact.Screen.Pixels = cut(screen.Pixels, sharedScreen.Pixels);\n"
         "    --contact.Screen.Pixels.X1;")],
    "equal depths thought hidden where only their farthest place is": [
        (PROJECTION, "sharedScreen.Nearest - error", "sharedScreen.Farthest")],
    "representations of a shared mapper not compared": [
        ("vtkNBufferSharedState.cxx",
         "  Combine(way, static_cast<std::size_t>(property->GetRepresentation()));\n"
         "  Combine(way, static_cast<std::size_t>(property->GetInterpolation()));\n",
         "  Combine(way, static_cast<std::size_t>(property->GetInterpolation()));\n")],
    "changes of observed objects not noticed": [
        ("vtkNBufferCandidateList.cxx", "!this->Observed.TakeChange() && !lost;", "true;")],
    "changes of observed actors not noticed": [
        ("vtkNBufferCandidateList.cxx",
         "!this->ObservedActors.TakeChange() && unchanged && !globalStateChanged;",
         "unchanged && !globalStateChanged;")],

    # Props that are none of the tested kind.
    "translucent props hide": [
        (CANDIDATE,
         "if (actor->HasTranslucentPolygonalGeometry() || !actor->HasOpaqueGeometry())",
         "if (actor->GetMapper() == nullptr)")],
    "wireframes and points are tested as surfaces": [
        ("vtkNBufferSurface.cxx", "return property->GetRepresentation() == VTK_SURFACE &&",
         "return")],
    "passes do not reach what is held back": [
        ("vtkNBufferStandIn.cxx",
         "if (!from || (passes->Length(from) == 0 && !from->Has(depthMask)))", "if (to)")],
}

# Found in scenes with shadow volumes.
SHADOW_MUTANTS = {
    # Litmaps, boxes and slabs.
    "litmap query without the lexels at the border": [
        ("vtkShadowLitmap.cxx",
         "this->P.GetCell(p1 + guardP) + 1, this->Q.GetCell(q1 + guardQ) + 1 };",
         "this->P.GetCell(p1), this->Q.GetCell(q1) };")],
    "box of pixels one column short": [
        (DRAW_LIST, "draw.Box = box;",
         "draw.Box = box;\n    --draw.Box.X1;")],
    "receivers next to the caster count as before it": [
        (PLAN, "lookup.IsInOneFace && lookup.Extent.Far < lookup.Near)",
         "lookup.IsInOneFace && lookup.Extent.Far < lookup.Far)")],
    "only one corner of a caster's box is tested": [
        (LITMAP_SET, "vtkShadowFootprint::Make(*points, *face.Space).Block : box);",
         "vtkShadowFootprint::Make(*points, *face.Space).Block\n"
         "                    : vtkShadowFootprint::Make(std::array{ corners[0] }, *face.Space).Block);")],
    "casters through the light's plane as others": [
        ("vtkShadowLitmapSet.h", "&& !(block.Low[2] > Margin * std::abs(block.High[2]));",
         "&& Margin < 0.0;")],
    "receivers behind an edge are not tested": [
        ("vtkShadowUmbra.h", "return this->MayShadow(tile[0]) || this->MayShadow(tile[1]);",
         "return this->MayShadow(tile[0]);")],
    "sides of triangles that look the wrong way": [
        (REACH, "(inside > 0.0 ? -1.0 : 1.0) / length;", "1.0 / length;")],
    "receivers must be beyond the planes of all triangles, not of one": [
        (REACH, "return std::any_of(this->Facets.begin(), this->Facets.end(),\n      [&](",
         "return std::all_of(this->Facets.begin(), this->Facets.end(),\n      [&](")],
    "a face around a point light left out": [
        ("vtkShadowLight.cxx", "for (int i = 0; i < 6; ++i)", "for (int i = 0; i < 5; ++i)")],

    # Volumes and counting.
    "z-pass where the piece crosses the near plane": [
        (DRAW_LIST, "return isBeyond(piece.Points, 1.0) && isBeyond(piece.Directions, 0.0);",
         "return isBeyond(piece.Directions, 0.0);")],
    "casters in a spot's cone are left out without litmaps": [
        ("vtkShadowLitmapSet.cxx", "nearest.Angle - this->GetWidestAngle());", "nearest.Angle);")],
    "the last plan of whole volumes is kept when the light or a caster changes": [
        ("vtkShadowMaskMaker.cxx", "    work.LightVolumes.Whole.reset();\n", ""),
        ("vtkShadowMaskMaker.cxx", "volumes.CastersVersion != version ||", "")],
    "far cap of a clamped piece missing": [
        (VOLUME, "  }\n  this->AddFan(silhouette, farImage, Side::Far);", "  }")],
    "volumes of casters that moved are kept": [
        ("vtkShadowVolumeStore.cxx", "try_emplace(caster.Silhouette.GetMTime())",
         "try_emplace(reinterpret_cast<vtkMTimeType>(&caster))")],
    "volumes along which a parallel camera looks are infinite": [
        (DRAW_LIST, "(light.IsPositional() || isAlong);", "light.IsPositional();")],
    "near cap missing": [
        (VOLUME,
         "this->AddTriangles(silhouette, nearImage, Side::Near);\n\n  if (light.IsPositional())",
         "if (light.IsPositional())")],
    "multiplicity of edges left out": [
        ("vtkShadowSilhouette.cxx", "this->Edges.push_back({ edge.A, edge.B, left });",
         "this->Edges.push_back({ edge.A, edge.B, 1 });")],
    "the inside of closed casters not seen": [
        (CASTER, "|| this->Bounds.Meets(nearBounds)", "")],
    "masks of pixels where nothing is seen": [
        ("vtkShadowCounter.cxx", "glDepthFunc(vtkNBufferDepthConvention::PassIfFarther);",
         "glDepthFunc(GL_ALWAYS);")],

    # From frame to frame.
    "stale silhouettes after a change of matrix or mesh": [
        (CASTER, "this->Slots.clear();", "")],
    "stale silhouettes of a light that moved": [
        (CASTER, "&& cached.Light == light &&", "&&")],
    "frame key without lights": [
        (FRAME_KEY, "this->Lights == other.Lights &&", "")],
    "frame key without the camera": [
        (FRAME_KEY, "this->View.HasSameView(other.View) &&", "")],
    "frame key without props": [
        (FRAME_KEY, "this->PropsVersion == other.PropsVersion &&", "")],
    "keys of casters not looked at again": [
        ("vtkShadowCasterList.cxx", " ||\n      member.Casts != member.HasRequiredKeys", "")],
    "shaders kept when lights change": [
        ("vtkShadowShading.cxx", "this->Time.Modified();", "")],
}

# These leave an error in so few frames that ten times as many are granted: other tolerances cover
# most of what the missing one let through, or the frames that show it are rare.
RARE = {
    "boxes of blocks that have moved": [
        (BLOCKS, "std::max(mapper->GetMTime(), dataTime);", "mapper->GetMTime();")],
    "offsets that visible edges switch on are ignored": [
        (SURFACE, "!= VTK_RESOLVE_OFF ||\n    actor->GetProperty()->GetEdgeVisibility();",
         "!= VTK_RESOLVE_OFF;")],
    "a mapper keeps the list of the blocks that were drawn": [
        ("vtkNBufferBlockStream.cxx", "this->Exchanged->swap(*GetBlockList(this->Changed).Blocks);", "")],
    "equal depths inside of a mesh not found by the device": [
        ("vtkNBufferTieQuery.cxx", "return passed > 0;", "return false;")],
    "only one part of what is drawn again followed": [
        ("vtkNBufferTieOrder.cxx",
         "for (int i = begin; i < end; ++i)\n      {\n        sources.Add({ i, std::numeric",
         "for (int i = begin; i <= begin; ++i)\n      {\n        sources.Add({ i, std::numeric")],
    "changes upstream of a mapper not noticed": [
        ("vtkNBufferPropWatch.h", "Means::Pipeline ? this->PipelineHasChanged()",
         "Means::Pipeline ? false")],
    "the last column of a cut base texel left out": [
        ("vtkNBufferLevels.cxx", "for (int x = whole * factor + 1; x < width; ++x)",
         "for (int x = whole * factor + 1; x < width - 1; ++x)")],
    "hierarchy not refit to props that move": [
        (CANDIDATE_TREE, "this->Tree.Move(place, candidate.GetBox());", "")],
    "no slack for rounded vertices in x and y": [
        (PROJECTION, "ndc - slack);", "ndc - slack * glm::dvec3(0.0, 0.0, 1.0));"),
        (PROJECTION, "ndc + slack);", "ndc + slack * glm::dvec3(0.0, 0.0, 1.0));")],
    "a square's level looked up that was not built (< turned to <=)": [
        ("vtkNBufferPixelTest.cxx", "this->SquareLevel < this->Levels.GetNumberOfLevels()",
         "this->SquareLevel <= this->Levels.GetNumberOfLevels()")],
}

RARE_SHADOWS = {
    "volumes of parallel cameras end within the view": [
        (VOLUME, "Lengthening = 1.01;", "Lengthening = 0.5;")],
    "slabs that begin at the caster end with the first of them": [
        (PLAN, "slabs.back().Far = far;", "slabs.back().Far = std::min(far, slabs.back().Far);")],
    "half of a spot's cone angle": [
        (LITMAP_SET, "vtkMath::RadiansFromDegrees(this->Light.ConeAngle) + margin;",
         "0.5 * vtkMath::RadiansFromDegrees(this->Light.ConeAngle) + margin;")],
    "volumes beyond the range of the stencil are not counted in portions": [
        (MASK_MAKER,
         "const bool allAtOnce = plan.IsCountWithin(vtkShadowCaster::MaximumCount);",
         "const bool allAtOnce = true;")],
    "instances of glyphs cast from where they were": [
        ("vtkShadowCasterList.cxx", "mesh.InstancesTime == instancesTime && ", "")],
    "clipping planes ignored": [
        (CASTER, "if (!planes.empty())", "if (planes.size() > 9)")],
}

# These change no image: what they take away is there twice, or is only about speed. They are run
# with --equivalent, to see that the fuzzer does not report what is no error.
EQUIVALENT = {
    # Equal depth has to count as visible. But Nearest is the depth less a slack that is never 0, so
    # that where the two numbers are equal the prop lies at least the slack behind the depth.
    "equal numbers count as hidden (> turned to >=)": [
        ("vtkNBufferOcclusionTest.cxx", "return screen.Nearest - this->Levels.Query(cover);",
         "const double clearance = screen.Nearest - this->Levels.Query(cover); "
         "return clearance == 0.0 ? 1e-30 : clearance;")],
    # What is before the near plane and in front of the eye has a negative depth, which nothing hides.
    "crossing the near plane counts as inside, crossing the eye does not": [
        (PROJECTION, NEAR_PLANE_TEST, "if (!(w > this->Error.w))")],
    # The next frame begins with more props than it needs.
    "visible props are not remembered": [
        (VIEW, "      state.WasVisible = true;\n", "")],
}
