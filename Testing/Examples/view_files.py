# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes one small scene in many formats: a wall, and a block of 4 x 4 x 4 boxes behind it.

From the first view of nbuffer-view parts of it hide others. Each writer takes the boxes, as (lower
corner, upper corner), and returns the contents of a file; vtm() writes several files.
"""

import base64
import gzip
import io
import json
import re
import struct
import zipfile

CORNERS = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
FACES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


def boxes():
    """65 boxes: the first one is the wall."""
    small = [((x, y, z), (x + 0.7, y + 0.7, z + 0.7))
             for x in range(4) for y in range(4) for z in range(4)]
    return [((-1.0, 5.0, -1.0), (5.0, 5.4, 5.0)), *small]


def points_of(box):
    low, high = box
    return [tuple((low, high)[bit][axis] for axis, bit in enumerate(corner)) for corner in CORNERS]


def mesh(parts):
    """All points, and all faces as numbers of points."""
    points, faces = [], []
    for part in parts:
        faces += [tuple(len(points) + corner for corner in face) for face in FACES]
        points += points_of(part)
    return points, faces


def triangles(faces):
    for a, b, c, d in faces:
        yield a, b, c
        yield a, c, d


def words(rows):
    return "\n".join(" ".join(f"{value:g}" for value in row) for row in rows)


def obj(parts):
    """A group for each part."""
    text, first = "", 1
    for number, part in enumerate(parts):
        text += f"g box{number}\n"
        text += "".join(f"v {x:g} {y:g} {z:g}\n" for x, y, z in points_of(part))
        text += "".join("f " + " ".join(str(first + i) for i in face) + "\n" for face in FACES)
        first += 8
    return text


def stl(parts):
    points, faces = mesh(parts)
    text = "solid boxes\n"
    for corners in triangles(faces):
        text += "facet normal 0 0 0\nouter loop\n"
        text += "".join("vertex " + " ".join(f"{v:g}" for v in points[i]) + "\n" for i in corners)
        text += "endloop\nendfacet\n"
    return text + "endsolid boxes\n"


def binary_stl(parts):
    points, faces = mesh(parts)
    all_triangles = list(triangles(faces))
    data = b"binary".ljust(80) + struct.pack("<I", len(all_triangles))
    for corners in all_triangles:
        data += struct.pack("<12fH", 0, 0, 0, *(v for i in corners for v in points[i]), 0)
    return data


def ply(parts):
    points, faces = mesh(parts)
    return (f"ply\nformat ascii 1.0\nelement vertex {len(points)}\nproperty float x\n"
            f"property float y\nproperty float z\nelement face {len(faces)}\n"
            "property list uchar int vertex_indices\nend_header\n"
            f"{words(points)}\n{words((4, *face) for face in faces)}\n")


def binary_ply(parts):
    points, faces = mesh(parts)
    header = ply(parts).split("end_header\n", maxsplit=1)[0].replace("ascii", "binary_big_endian")
    return (header.encode() + b"end_header\n" + b"".join(struct.pack(">3f", *p) for p in points) +
            b"".join(struct.pack(">B4i", 4, *face) for face in faces))


def off(parts):
    points, faces = mesh(parts)
    return (f"OFF\n{len(points)} {len(faces)} 0\n{words(points)}\n"
            f"{words((4, *face) for face in faces)}\n")


def vtk(parts):
    points, faces = mesh(parts)
    return ("# vtk DataFile Version 3.0\nboxes\nASCII\nDATASET POLYDATA\n"
            f"POINTS {len(points)} float\n{words(points)}\n"
            f"POLYGONS {len(faces)} {5 * len(faces)}\n{words((4, *face) for face in faces)}\n")


def new_vtk(parts):
    """Version 5.1, binary."""
    points, faces = mesh(parts)
    numbers = [i for face in faces for i in face]
    data = b"# vtk DataFile Version 5.1\nboxes\nBINARY\nDATASET POLYDATA\n"
    data += f"POINTS {len(points)} float\n".encode()
    data += b"".join(struct.pack(">3f", *point) for point in points)
    data += f"\nPOLYGONS {len(faces) + 1} {len(numbers)}\nOFFSETS vtktypeint64\n".encode()
    data += struct.pack(f">{len(faces) + 1}q", *range(0, len(numbers) + 1, 4))
    data += b"\nCONNECTIVITY vtktypeint64\n" + struct.pack(f">{len(numbers)}q", *numbers)
    return data + b"\n"


def array(name, kind, rows, components=1):
    return (f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" '
            f'format="ascii">\n{words(rows)}\n</DataArray>')


def xml(kind, body):
    return (f'<?xml version="1.0"?>\n<VTKFile type="{kind}" version="1.0" '
            f'byte_order="LittleEndian">\n{body}\n</VTKFile>\n')


def vtp(parts):
    points, faces = mesh(parts)
    offsets = [(4 * (i + 1),) for i in range(len(faces))]
    return xml("PolyData", f'<PolyData><Piece NumberOfPoints="{len(points)}" NumberOfVerts="0" '
               f'NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="{len(faces)}">'
               f'<Points>{array("Points", "Float32", points, 3)}</Points>'
               f'<Polys>{array("connectivity", "Int64", faces)}'
               f'{array("offsets", "Int64", offsets)}</Polys></Piece></PolyData>')


def vtu(parts):
    """A hexahedron for each part."""
    points, _ = mesh(parts)
    cells = [tuple(8 * i + corner for corner in (0, 1, 3, 2, 4, 5, 7, 6))
             for i in range(len(parts))]
    return xml("UnstructuredGrid",
               f'<UnstructuredGrid><Piece NumberOfPoints="{len(points)}" '
               f'NumberOfCells="{len(cells)}"><Points>{array("Points", "Float32", points, 3)}'
               f'</Points><Cells>{array("connectivity", "Int64", cells)}'
               f'{array("offsets", "Int64", [(8 * (i + 1),) for i in range(len(cells))])}'
               f'{array("types", "UInt8", [(12,)] * len(cells))}</Cells></Piece>'
               '</UnstructuredGrid>')


GRID = 'WholeExtent="0 3 0 3 0 3"'
NODES = [(x, y, z) for z in range(4) for y in range(4) for x in range(4)]


def vti(_):
    return xml("ImageData", f'<ImageData {GRID} Origin="0 0 0" Spacing="1 1 1">'
               '<Piece Extent="0 3 0 3 0 3"></Piece></ImageData>')


def vtr(_):
    axes = "".join(array(axis, "Float32", [(0,), (1,), (2,), (4,)]) for axis in "xyz")
    return xml("RectilinearGrid", f'<RectilinearGrid {GRID}><Piece Extent="0 3 0 3 0 3">'
               f'<Coordinates>{axes}</Coordinates></Piece></RectilinearGrid>')


def vts(_):
    return xml("StructuredGrid", f'<StructuredGrid {GRID}><Piece Extent="0 3 0 3 0 3"><Points>'
               f'{array("Points", "Float32", NODES, 3)}</Points></Piece></StructuredGrid>')


def wrl(parts):
    text = "#VRML V2.0 utf8\n"
    for part in parts:
        points = words(points_of(part)).replace("\n", ", ")
        faces = ", -1, ".join(", ".join(str(i) for i in face) for face in FACES)
        text += ("Shape { appearance Appearance { material Material { diffuseColor 0.8 0.7 0.4 } }\n"
                 f" geometry IndexedFaceSet {{ coord Coordinate {{ point [ {points} ] }}\n"
                 f"  coordIndex [ {faces}, -1 ] }} }}\n")
    return text


def gltf_and_buffer(parts):
    """A node for each part, all of one mesh; y points up."""
    points, faces = mesh([((0.0, 0.0, 0.0), (1.0, 1.0, 1.0))])
    numbers = [i for corners in triangles(faces) for i in corners]
    data = b"".join(struct.pack("<3f", *point) for point in points)
    data += struct.pack(f"<{len(numbers)}H", *numbers)
    nodes = []
    for number, (low, high) in enumerate(parts):
        nodes.append({"mesh": 0, "name": f"box{number}",
                      "translation": [low[0], low[2], -high[1]],
                      "scale": [high[0] - low[0], high[2] - low[2], high[1] - low[1]]})
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}],
        "nodes": nodes,
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [{"byteLength": len(data)}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 96},
                        {"buffer": 0, "byteOffset": 96, "byteLength": len(data) - 96}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3",
             "min": [0, 0, 0], "max": [1, 1, 1]},
            {"bufferView": 1, "componentType": 5123, "count": len(numbers), "type": "SCALAR"}]}
    return document, data


def gltf(parts):
    document, data = gltf_and_buffer(parts)
    document["buffers"][0]["uri"] = ("data:application/octet-stream;base64," +
                                     base64.b64encode(data).decode())
    return json.dumps(document)


def glb(parts):
    document, data = gltf_and_buffer(parts)
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    data += b"\0" * (-len(data) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
    chunks += struct.pack("<II", len(data), 0x004E4942) + data
    return struct.pack("<III", 0x46546C67, 2, 12 + len(chunks)) + chunks


def chunk_3ds(number, body):
    return struct.pack("<HI", number, 6 + len(body)) + body


def tds(parts):
    """3D Studio: an object for each part."""
    objects = b""
    for number, part in enumerate(parts):
        points, faces = mesh([part])
        numbers = list(triangles(faces))
        data = chunk_3ds(0x4110, struct.pack("<H", len(points)) +
                         b"".join(struct.pack("<3f", *point) for point in points))
        data += chunk_3ds(0x4120, struct.pack("<H", len(numbers)) +
                          b"".join(struct.pack("<4H", *corners, 0) for corners in numbers))
        objects += chunk_3ds(0x4000, f"box{number}".encode() + b"\0" + chunk_3ds(0x4100, data))
    return chunk_3ds(0x4D4D, chunk_3ds(0x3D3D, objects))


def gml(parts):
    """CityGML: a building of level 2 for each part, all of its surfaces in one wall."""
    text = ('<?xml version="1.0" encoding="UTF-8"?>\n<CityModel '
            'xmlns="http://www.opengis.net/citygml/2.0" '
            'xmlns:bldg="http://www.opengis.net/citygml/building/2.0" '
            'xmlns:gml="http://www.opengis.net/gml">\n')
    for number, part in enumerate(parts):
        points = points_of(part)
        members = ""
        for face in FACES:
            ring = " ".join(f"{v:g}" for i in (*face, face[0]) for v in points[i])
            members += ("<gml:surfaceMember><gml:Polygon><gml:exterior><gml:LinearRing>"
                        f'<gml:posList srsDimension="3">{ring}</gml:posList></gml:LinearRing>'
                        "</gml:exterior></gml:Polygon></gml:surfaceMember>")
        text += (f'<cityObjectMember><bldg:Building gml:id="house{number}"><bldg:boundedBy>'
                 f'<bldg:WallSurface gml:id="wall{number}"><bldg:lod2MultiSurface>'
                 f"<gml:MultiSurface>{members}</gml:MultiSurface></bldg:lod2MultiSurface>"
                 "</bldg:WallSurface></bldg:boundedBy></bldg:Building></cityObjectMember>\n")
    return text + "</CityModel>\n"


def dae(parts):
    """COLLADA: one geometry, a node for each part; z points up."""
    points, faces = mesh([((0.0, 0.0, 0.0), (1.0, 1.0, 1.0))])
    values = words(points).replace("\n", " ")
    numbers = " ".join(str(i) for corners in triangles(faces) for i in corners)
    nodes = ""
    for number, (low, high) in enumerate(parts):
        scale = " ".join(f"{b - a:g}" for a, b in zip(low, high))
        place = " ".join(f"{a:g}" for a in low)
        nodes += (f'<node id="box{number}" name="box{number}"><translate>{place}</translate>'
                  f'<scale>{scale}</scale><instance_geometry url="#cube"/></node>\n')
    return ('<?xml version="1.0" encoding="utf-8"?>\n<COLLADA version="1.4.1" '
            'xmlns="http://www.collada.org/2005/11/COLLADASchema"><asset><up_axis>Z_UP</up_axis>'
            '</asset><library_geometries><geometry id="cube"><mesh><source id="p">'
            f'<float_array id="a" count="24">{values}</float_array><technique_common>'
            '<accessor source="#a" count="8" stride="3"><param name="X" type="float"/>'
            '<param name="Y" type="float"/><param name="Z" type="float"/></accessor>'
            '</technique_common></source><vertices id="v"><input semantic="POSITION" '
            'source="#p"/></vertices><triangles count="12"><input semantic="VERTEX" '
            f'source="#v" offset="0"/><p>{numbers}</p></triangles></mesh></geometry>'
            f'</library_geometries><library_visual_scenes><visual_scene id="s">\n{nodes}'
            '</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/>'
            "</scene></COLLADA>\n")


def threemf(parts):
    """An object for each part."""
    objects, items = "", ""
    for number, part in enumerate(parts, 1):
        points, faces = mesh([part])
        vertices = "".join(f'<vertex x="{x:g}" y="{y:g}" z="{z:g}"/>' for x, y, z in points)
        corners = "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in triangles(faces))
        objects += (f'<object id="{number}" type="model"><mesh><vertices>{vertices}</vertices>'
                    f"<triangles>{corners}</triangles></mesh></object>")
        items += f'<item objectid="{number}"/>'
    schema = "http://schemas.openxmlformats.org/package/2006"
    core = "http://schemas.microsoft.com/3dmanufacturing"
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as file:
        file.writestr("[Content_Types].xml", '<?xml version="1.0"?><Types xmlns="'
                      f'{schema}/content-types"><Default Extension="rels" ContentType="application/'
                      'vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" '
                      'ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>')
        file.writestr("_rels/.rels", f'<?xml version="1.0"?><Relationships xmlns="{schema}/'
                      'relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" '
                      f'Type="{core}/2013/01/3dmodel"/></Relationships>')
        file.writestr("3D/3dmodel.model", '<?xml version="1.0"?><model unit="millimeter" '
                      f'xmlns="{core}/core/2015/02"><resources>{objects}</resources>'
                      f"<build>{items}</build></model>")
    return packed.getvalue()


def ifc(parts):
    """IFC 2x3: a proxy for each part, with an extruded rectangle as its body."""
    lines = ["#1=IFCCARTESIANPOINT((0.,0.,0.));", "#2=IFCDIRECTION((0.,0.,1.));",
             "#3=IFCDIRECTION((1.,0.,0.));", "#4=IFCAXIS2PLACEMENT3D(#1,#2,#3);",
             "#5=IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-5,#4,$);",
             "#6=IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.);", "#7=IFCUNITASSIGNMENT((#6));",
             "#15=IFCORGANIZATION($,'o',$,$,$);", "#16=IFCPERSON('','',$,$,$,$,$,$);",
             "#17=IFCPERSONANDORGANIZATION(#16,#15,$);", "#18=IFCAPPLICATION(#15,'1','a','a');",
             "#19=IFCOWNERHISTORY(#17,#18,$,.NOCHANGE.,$,$,$,0);",
             "#8=IFCPROJECT('p',#19,'boxes',$,$,$,$,(#5),#7);", "#9=IFCLOCALPLACEMENT($,#4);",
             "#10=IFCBUILDING('b',#19,'building',$,$,#9,$,$,.ELEMENT.,$,$,$);",
             "#11=IFCRELAGGREGATES('a',#19,$,$,#8,(#10));",
             "#12=IFCCARTESIANPOINT((0.,0.));", "#13=IFCDIRECTION((1.,0.));",
             "#14=IFCAXIS2PLACEMENT2D(#12,#13);"]
    products = []
    for number, (low, high) in enumerate(parts):
        first = 100 + 20 * number
        width, depth, height = (b - a for a, b in zip(low, high))
        place = ",".join(f"{v:.3f}" for v in
                         (0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), low[2]))
        lines += [f"#{first}=IFCCARTESIANPOINT(({place}));",
                  f"#{first + 1}=IFCAXIS2PLACEMENT3D(#{first},#2,#3);",
                  f"#{first + 2}=IFCLOCALPLACEMENT(#9,#{first + 1});",
                  f"#{first + 3}=IFCRECTANGLEPROFILEDEF(.AREA.,$,#14,{width:.3f},{depth:.3f});",
                  f"#{first + 4}=IFCEXTRUDEDAREASOLID(#{first + 3},#4,#2,{height:.3f});",
                  f"#{first + 5}=IFCSHAPEREPRESENTATION(#5,'Body','SweptSolid',(#{first + 4}));",
                  f"#{first + 6}=IFCPRODUCTDEFINITIONSHAPE($,$,(#{first + 5}));",
                  f"#{first + 7}=IFCBUILDINGELEMENTPROXY('g{number}',#19,'box{number}',$,$,"
                  f"#{first + 2},#{first + 6},$,$);"]
        products.append(f"#{first + 7}")
    lines.append(f"#90=IFCRELCONTAINEDINSPATIALSTRUCTURE('r',#19,$,$,({','.join(products)}),#10);")
    return ("ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
            "FILE_NAME('','',(''),(''),'','','');\nFILE_SCHEMA(('IFC2X3'));\nENDSEC;\nDATA;\n" +
            "\n".join(lines) + "\nENDSEC;\nEND-ISO-10303-21;\n")


def vtm(folder, parts):
    """A block for each part, each in a file of its own."""
    blocks = ""
    for number, part in enumerate(parts):
        (folder / f"block{number}.vtp").write_text(vtp([part]))
        blocks += f'<DataSet index="{number}" name="box{number}" file="block{number}.vtp"/>\n'
    (folder / "boxes.vtm").write_text(
        xml("vtkMultiBlockDataSet", f"<vtkMultiBlockDataSet>\n{blocks}</vtkMultiBlockDataSet>"))
    # Partitioned data sets have one partition each here.
    parts_text = "".join(f'<Partitions index="{i}" name="box{i}"><DataSet index="0" '
                         f'file="block{i}.vtp"/></Partitions>\n' for i in range(len(parts)))
    (folder / "boxes.vtpc").write_text(
        xml("vtkPartitionedDataSetCollection", "<vtkPartitionedDataSetCollection>\n"
            f"{parts_text}</vtkPartitionedDataSetCollection>"))


# By the ending: the writer, and how many parts the viewer makes of the scene.
WRITERS = {
    ".obj": (obj, 65), ".stl": (stl, 65), ".ply": (ply, 65), ".vtk": (vtk, 65), ".vtp": (vtp, 65),
    ".vtu": (vtu, 65), ".vti": (vti, 1), ".vtr": (vtr, 1), ".vts": (vts, 1), ".wrl": (wrl, 65),
    ".vrml": (wrl, 65), ".gltf": (gltf, 65), ".glb": (glb, 65), ".3ds": (tds, 65),
    ".gml": (gml, 65), ".citygml": (gml, 65), ".off": (off, 65), ".dae": (dae, 65),
    ".3mf": (threemf, 65), ".ifc": (ifc, 65)}


def write_all(folder):
    """Writes the scene in all formats; returns the expected numbers of parts by file."""
    parts = boxes()
    expected = {}
    for ending, (writer, count) in WRITERS.items():
        contents = writer(parts)
        file = folder / f"boxes{ending}"
        file.write_bytes(contents if isinstance(contents, bytes) else contents.encode())
        expected[file] = count
    (folder / "binary.stl").write_bytes(binary_stl(parts))
    (folder / "binary.ply").write_bytes(binary_ply(parts))
    (folder / "packed.ply.gz").write_bytes(gzip.compress(ply(parts).encode()))
    (folder / "binary.vtk").write_bytes(new_vtk(parts))
    (folder / "whole.obj").write_text(re.sub("^g .*\n", "", obj(parts), flags=re.MULTILINE))
    for name in ("whole.obj", "binary.stl", "binary.ply", "binary.vtk", "packed.ply.gz"):
        expected[folder / name] = 65
    vtm(folder, parts)
    expected[folder / "boxes.vtm"] = expected[folder / "boxes.vtpc"] = 65
    return expected
