// SPDX-License-Identifier: GPL-3.0-or-later
// Shows the part of the page: drag to turn, right button to move, wheel to zoom. "#az=45&el=30&zoom=1" sets the view.
(function () {
  'use strict';
  var place = document.getElementById('view');
  var data = document.getElementById('glb');
  if (!place || !data || typeof THREE === 'undefined') return;
  var renderer;
  try {
    renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
  } catch (error) {
    place.textContent = place.dataset.none;
    return;
  }
  var text = atob(data.textContent.trim());
  var bytes = new Uint8Array(text.length);
  for (var k = 0; k < text.length; k++) bytes[k] = text.charCodeAt(k);
  renderer.gammaOutput = true;
  renderer.gammaFactor = 2.2;
  renderer.setPixelRatio(window.devicePixelRatio || 1);
  place.appendChild(renderer.domElement);
  var scene = new THREE.Scene();
  var camera = new THREE.PerspectiveCamera(30, 1, 0.001, 100);
  var controls = new THREE.OrbitControls(camera, renderer.domElement);
  controls.screenSpacePanning = true;
  scene.add(new THREE.HemisphereLight(0xffffff, 0x8a929a, 0.75));
  var lamp = new THREE.DirectionalLight(0xffffff, 0.55);
  camera.add(lamp);
  lamp.position.set(-0.6, 0.8, 1);
  scene.add(camera);
  function draw() { renderer.render(scene, camera); }
  function resize() {
    var width = place.clientWidth, height = place.clientHeight;
    renderer.setSize(width, height, false);
    renderer.domElement.style.width = width + 'px';
    renderer.domElement.style.height = height + 'px';
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    draw();
  }
  function wanted() {
    var values = { az: -35, el: 38, zoom: 1 };
    location.hash.replace(/([a-z]+)=(-?[\d.]+)/g, function (all, key, value) { values[key] = parseFloat(value); return all; });
    return values;
  }
  new THREE.GLTFLoader().parse(bytes.buffer, '', function (gltf) {
    scene.add(gltf.scene);
    var box = new THREE.Box3().setFromObject(gltf.scene);
    var middle = box.getCenter(new THREE.Vector3());
    var size = box.getSize(new THREE.Vector3()).length();
    function look() {
      var view = wanted();
      var az = view.az * Math.PI / 180, el = view.el * Math.PI / 180;
      var away = 1.6 * size / view.zoom;
      camera.near = away / 100;
      camera.far = away * 10;
      controls.target.copy(middle);
      camera.position.set(middle.x + away * Math.cos(el) * Math.sin(az), middle.y + away * Math.sin(el), middle.z + away * Math.cos(el) * Math.cos(az));
      controls.update();
      resize();
    }
    controls.addEventListener('change', draw);
    window.addEventListener('resize', resize);
    window.addEventListener('hashchange', look);
    look();
    setTimeout(function () { draw(); document.body.dataset.drawn = 'yes'; }, 0);
  }, function (error) { place.textContent = String(error); });
})();
