// Shapes of the document as meshes.
import {
  BoxGeometry, BufferAttribute, BufferGeometry, CapsuleGeometry, CylinderGeometry, EdgesGeometry, Group,
  InstancedMesh, LineBasicMaterial, LineSegments, Matrix4, Mesh, SphereGeometry,
} from "three";

const edgeMaterial = new LineBasicMaterial({ color: 0x000000, transparent: true, opacity: 0.22 });

/** Puts an object at a pose of seven numbers. */
export function place(object, [x, y, z, qx, qy, qz, qw]) {
  object.position.set(x, y, z);
  object.quaternion.set(qx, qy, qz, qw);
}

const alongZ = (geometry) => geometry.rotateX(Math.PI / 2);

const geometries = {
  sphere: ({ radius }) => new SphereGeometry(radius, 32, 20),
  box: ({ size }) => new BoxGeometry(...size),
  cylinder: ({ radius, length }) => alongZ(new CylinderGeometry(radius, radius, length, 40)),
  capsule: ({ radius, length }) => alongZ(new CapsuleGeometry(radius, length, 10, 28)),
  mesh: ({ vertices, triangles }) => {
    const soup = new BufferGeometry();
    soup.setAttribute("position", new BufferAttribute(new Float32Array(vertices), 3));
    soup.setIndex(triangles);
    const flat = soup.toNonIndexed();
    flat.computeVertexNormals();
    return flat;
  },
};

function voxels({ edge, centers }, material) {
  const mesh = new InstancedMesh(new BoxGeometry(edge, edge, edge), material, centers.length / 3);
  const matrix = new Matrix4();
  for (let i = 0; i < centers.length / 3; ++i)
    mesh.setMatrixAt(i, matrix.makeTranslation(...centers.slice(3 * i, 3 * i + 3)));
  return mesh;
}

/** All shapes of a link or body, in its frame. */
export function makeShapes(shapes, material) {
  const group = new Group();
  for (const shape of shapes) {
    const mesh = shape.type === "voxels" ? voxels(shape, material) : new Mesh(geometries[shape.type](shape), material);
    mesh.castShadow = mesh.receiveShadow = !material.transparent;
    place(mesh, shape.pose);
    if (shape.type === "box" && !material.transparent)
      mesh.add(new LineSegments(new EdgesGeometry(mesh.geometry), edgeMaterial));
    group.add(mesh);
  }
  return group;
}

/** Gives all faces below an object a material. */
export function paint(object, material) {
  object.traverse((part) => {
    if (part.isMesh) part.material = material;
  });
}
